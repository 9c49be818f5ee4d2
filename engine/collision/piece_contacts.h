/// The contacts of compounds and meshes: of what their pieces have in common, all that has one normal
/// is one contact of at most four points. A table on a tiled floor stands on its four feet, and they
/// are solved as one, where a contact for every foot and tile would quarrel over the weight.
#pragma once
#include "engine/collision/contact_making.h"
#include "engine/collision/moving_contacts.h"

namespace engine {

/// Pushes the pair's contacts to `found`; `previous`: those of the last step, of this pair from `old` on.
/// `near` (m): as far as this step's hits may bring the two together.
void addContactsOfPieces(const Bodies& bodies, const PairKey& pair, const BroadPhase& broadPhase,
                         const MovingPairs& moving, double margin, double near, double dt,
                         const std::vector<Contact>& previous, std::size_t old,
                         std::vector<Contact>& found);

}  // namespace engine
