/// The camera of a scene that does not place its own: it sees the motion of the whole run.
#pragma once
#include <optional>
#include <span>

#include "demos/play/stage.h"

namespace demos {

/// Sets `from` and `lookAt` of the scenes whose camera fits the motion; all of them get the same,
/// so that variants can be compared. The box around all bodies that move, over the whole run,
/// then fills 70 % of a picture of 16:9. Planes and large fixed bodies do not count, nor do bodies
/// while they are far away from most others. Costs one run of each such scene, without pictures;
/// scenes that place their camera cost nothing.
void fitToMotion(std::span<SceneDescription* const> scenes);

/// m: the median, along each axis, of the places of the bodies that are not fixed; nothing if there
/// are none.
std::optional<Vec3> middleOf(const Stage& stage);

}  // namespace demos
