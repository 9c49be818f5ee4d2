/// Gravity towards a point.
///   F = m mu d / (|d|^2 + s^2)^(3/2),   d = centre - x,   E = -m mu / sqrt(|d|^2 + s^2)
/// With s = 0 a body at distance r orbits in T = 2 pi sqrt(r^3 / mu). A softening s > 0 keeps the
/// force finite at the centre.
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

void addLoads(const PointGravity& gravity, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);
double potentialOf(const PointGravity& gravity, std::span<const BodyId> on, const Bodies& bodies);

}  // namespace engine
