/// Makes persistent contacts from manifolds.
#pragma once
#include "engine/collision/broad_phase.h"
#include "engine/collision/manifold.h"
#include "engine/constraints/contact.h"

namespace engine {

enum class Found { here, onTheWay };  // at the present poses, or where the two will meet

Contact contactOf(const Bodies& bodies, const PairKey& pair, const Manifold& manifold, Found where);

/// Whether the two bodies have hardly moved relative to each other since the contact was found: less than a
/// quarter of the margin, so that no point is missed that may touch in the next step.
bool stays(const Contact& contact, const Bodies& bodies);

/// Makes it the same contact at the present poses: its normal turns with a.
void follow(Contact& contact, const Bodies& bodies);

/// C of a point at the present poses, m.
double separationOf(const Contact& contact, int point, const Bodies& bodies);
/// The smallest separation of its points, m.
double deepestOf(const Contact& contact, const Bodies& bodies);

}  // namespace engine
