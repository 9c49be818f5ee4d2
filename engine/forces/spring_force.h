/// A spring with a damper between a point of one body and a point of another, with W = h^2 k K, where K is
/// the change of d/dt |d| per unit of impulse along d:
///   v0 = d/dt |d|,   v1 = E ((1 - D) v0 - W (|d| - l) / h)        constraints/soft.h, with u = v0
///   F = (v0 - v1) / (K h) d / |d|,   d = p_b - p_a, on a; its opposite on b
///   U = k (|d| - l - v0 h / 2)^2 / 2                      at the moment of the velocities
/// So it swings with T = 2 pi sqrt(m / k), for a hundred periods and more without damping, and is stable at
/// any stiffness. Where n springs pull at a body, each gets an n-th of its mass (Tonge et al. 2012, 'Mass
/// splitting for jitter-free parallel rigid body simulation'), so together they do not overshoot either.
/// Where k h^2 exceeds m, they yield as if k were m / h^2; soft distance joints do not.
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
