/// The sun's direction: like a photographer's key light, to the left of the camera and above it.
#pragma once
#include "engine/base/math.h"
#include "render/frame.h"

namespace demos {

/// Unit, towards the light: 50 degrees to the left of the camera's first view and 38 above the
/// ground, so that faces differ and shadows lie next to their bodies. from, lookAt: m.
render::Vec3 keyLight(const engine::Vec3& from, const engine::Vec3& lookAt);

}  // namespace demos
