/// A force that stays, and one that turns with the body (thrust).
///   F, T = (p - x) x F + T0,   p = x + R at
#pragma once
#include <span>

#include "engine/body.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

struct ConstantForce {
    Vec3 force{0, 0, 0};   // N
    Vec3 torque{0, 0, 0};  // N m
    Vec3 at{0, 0, 0};      // m, body axes: where the force acts
    bool turns = false;    // false: force and torque in world axes; true: in body axes
};

void addLoads(const ConstantForce& force, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

}  // namespace engine
