/// The last safeguard for fast bodies: the centre of a convex body, or of a part of a compound, does not pass
/// through a mesh from its front.
/// A surface has no inside to be pushed out of, so a body that has passed through is lost. A sliver that hits
/// with a corner at 200 m/s may pass, because its contacts were found a moment earlier.
///   x <- where its centre met the surface, a little in front; its velocity is for the contacts to stop
#pragma once
#include <span>

#include "engine/collision/contacts.h"

namespace engine {

/// Moves back the bodies that have passed through since `before`, the poses at the last contact detection.
void holdInFront(Bodies& bodies, ContactFinder& finder, std::span<const Pose> before);

}  // namespace engine
