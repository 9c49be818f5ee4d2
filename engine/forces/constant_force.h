/// A force that is constant in world axes, or turns with the body (thrust).
///   F, T = (p - x) x F + T0,   p = x + R at
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

void addLoads(const ConstantForce& force, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);

}  // namespace engine
