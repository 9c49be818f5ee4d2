/// E = m v^2 / 2 + w.(I w) / 2 - m g.x, the check on everything else.
#pragma once
#include "engine/dynamics/bodies.h"
#include "engine/step_report.h"

namespace engine {

Energy energyOf(const Bodies& bodies, const Vec3& gravity);

/// kg m/s, and kg m^2/s about the origin.
struct Momentum {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};
Momentum momentumOf(const Bodies& bodies);

}  // namespace engine
