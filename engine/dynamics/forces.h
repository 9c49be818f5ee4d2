/// Step 1 of the loop: forces become accelerations.
///   a = g + F / m,   dw/dt = I^-1 T
#pragma once
#include <span>

#include "engine/dynamics/bodies.h"

namespace engine {

/// `bodies.loads` act for the whole step. `field` (one load per body, or empty) depends on the
/// poses and is evaluated again for every sub-step of its bodies.
void applyForces(Bodies& bodies, const Vec3& gravity, std::span<const Load> field);

}  // namespace engine
