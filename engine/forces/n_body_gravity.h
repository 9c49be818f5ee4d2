/// Gravity between bodies, each pair once, with equal and opposite forces.
///   F_ij = G m_i m_j d / (|d|^2 + s^2)^(3/2),   d = x_j - x_i
///   E = -G m_i m_j / sqrt(|d|^2 + s^2)
#pragma once
#include <span>

#include "engine/force.h"
#include "engine/forces/force_moment.h"

namespace engine {

struct Bodies;

/// The cost grows with the square of the number of bodies.
void addLoads(const NBodyGravity& gravity, std::span<const BodyId> on, const Bodies& bodies,
              const ForceMoment& now, std::span<Load> loads);
double potentialOf(const NBodyGravity& gravity, std::span<const BodyId> on, const Bodies& bodies);

}  // namespace engine
