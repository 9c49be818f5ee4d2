/// The result of a ray cast.
#pragma once
#include "engine/body.h"

namespace engine {

/// Where a ray enters a body.
struct RayHit {
    BodyId body;               // the first along the ray
    double fraction = 0.0;     // of the ray, 0 to 1
    Vec3 point{0, 0, 0};       // m, world axes
    Vec3 normal{0, 1, 0};      // unit, out of the body, world axes
};

}  // namespace engine
