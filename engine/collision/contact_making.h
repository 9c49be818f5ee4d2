/// From a manifold to the contact that persists.
#pragma once
#include "engine/collision/broad_phase.h"
#include "engine/collision/manifold.h"
#include "engine/constraints/contact.h"

namespace engine {

enum class Found { here, onTheWay };  // at the present poses, or where the two will meet

Contact contactOf(const Bodies& bodies, const PairKey& pair, const Manifold& manifold, Found where);

/// Whether the two bodies have hardly moved against each other since the contact was found: less than a
/// quarter of the margin, so that no point is missed that may touch in the next step.
bool stays(const Contact& contact, const Bodies& bodies);

/// Once more, found again by standing still: its normal turns with a.
Contact kept(const Contact& contact, const Bodies& bodies);

/// C of a point at the bodies' present poses, m.
double separationOf(const Contact& contact, int point, const Bodies& bodies);
/// Of the point that touches first.
double deepestOf(const Contact& contact, const Bodies& bodies);

}  // namespace engine
