/// Step 5 of the loop: correction nudges, impulses on positions (second seed).
///   lambda_n = -beta C / K,   x += M^-1 J^T lambda_n
/// with the same J and K as the impulses; C (and a joint's J) is evaluated again from the poses in every
/// sweep. Such a correction never becomes velocity: a body pushed out of the floor does not jump.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

constexpr double kMostNudge = 0.2;  // m: limit of one nudge, so that joints far apart close over
                                    // several steps; contacts have Settings::depenetrationSpeed

/// Nudges acting bodies, in a sub-step of the world of h (s). untilSeen: in how many of them others read the
/// velocities; trees that are solved again before may skip a solve (joint_nudges.h).
void solveNudges(std::span<Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h, int untilSeen);

}  // namespace engine
