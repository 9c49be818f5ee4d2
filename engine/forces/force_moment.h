/// The input of a force besides the bodies: the time, and how long the force will act.
#pragma once
#include <span>

#include "engine/base/math.h"

namespace engine {

struct ForceMoment {
    double time = 0.0;             // s, at the beginning of the sub-step
    double h = 0.0;                // s, the length of the sub-step
    Vec3 gravity = Vec3::Zero();   // m/s^2
    std::span<const int> springs;  // number of springs at a body, by body
};

}  // namespace engine
