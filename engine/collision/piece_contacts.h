/// The contacts of compounds and meshes: contact points of all their pieces with the same normal become one
/// contact of at most four points. The four feet of a table on a tiled floor are solved together, where
/// separate contacts for every foot and tile would compete for the weight.
#pragma once
#include "engine/collision/contact_making.h"
#include "engine/collision/moving_contacts.h"

namespace engine {

/// Appends the pair's contacts to `found`. `previous`: the contacts of the last step; those of this pair
/// start at `old`. `near` (m): how much closer the hits of this step may bring the two. `looked`: see
/// forPiecePairs(). `known`: the pair's entry of `moving`, if any. Returns true if all were kept, with their impulses.
bool addContactsOfPieces(const Bodies& bodies, const PairKey& pair, const BroadPhase& broadPhase,
                         const MovingPairs& moving, const MovingPairs::Entry* known, double margin,
                         double near, double dt,
                         const std::vector<Contact>& previous, std::size_t old, Looked& looked,
                         std::vector<Contact>& found);

}  // namespace engine
