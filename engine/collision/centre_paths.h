/// The last net under a fast body: the centre of a convex body, or of a part of a compound, does not pass a
/// mesh from its front.
/// A surface has no inside to push out of, so that who is once through it falls for good; a sliver that
/// hits with a corner at 200 m/s may be, its contacts being those of a moment before.
///   x <- where its centre met the surface, a little in front; its velocity is for the contacts to stop
#pragma once
#include <span>

#include "engine/collision/contacts.h"

namespace engine {

/// Bodies that came through since `before`, the poses at the last look for contacts, are put back.
void holdInFront(Bodies& bodies, const ContactFinder& finder, std::span<const Pose> before);

}  // namespace engine
