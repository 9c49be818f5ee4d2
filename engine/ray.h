/// A look along a straight way through a world.
#pragma once
#include "engine/body.h"

namespace engine {

/// Where the way enters a body.
struct RayHit {
    BodyId body;               // the first on the way
    double fraction = 0.0;     // of the way, 0 to 1
    Vec3 point{0, 0, 0};       // m, world axes
    Vec3 normal{0, 1, 0};      // unit, out of the body, world axes
};

}  // namespace engine
