/// A spring with a damper between a point of one body and a point of another.
///   F = (k (|d| - l) + c d/dt |d|) d / |d|,   d = p_b - p_a, on a; its opposite on b
///   E = k (|d| - l)^2 / 2
/// Explicit: it swings with T = 2 pi sqrt(m / k) as long as k h^2 is well below m. What is stiffer
/// is a soft distance joint (constraints/soft.h). The damper takes away the whole approach at most.
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

/// `on`: a and b.
void addLoads(const SpringForce& spring, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);
double potentialOf(const SpringForce& spring, std::span<const BodyId> on, const Bodies& bodies);

}  // namespace engine
