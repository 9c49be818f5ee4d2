/// What a force may know besides the bodies: when it is asked, and for how long it will act.
#pragma once
#include <span>

#include "engine/base/math.h"

namespace engine {

struct ForceMoment {
    double time = 0.0;             // s, at the beginning of the sub-step
    double h = 0.0;                // s, the length of the sub-step
    Vec3 gravity = Vec3::Zero();   // m/s^2
    std::span<const int> springs;  // that pull at a body, by body
};

}  // namespace engine
