/// Step 5 of the loop: correction nudges, impulses on positions (second seed).
///   lambda_n = -beta C / K,   x += M^-1 J^T lambda_n
/// with the same J and K as the impulses, C (and a joint's J) evaluated again from the poses in every
/// sweep. What is taken away from an error this way never becomes velocity: a body pushed out of the
/// floor does not jump.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

constexpr double kMostNudge = 0.2;  // m: what one nudge may move, so that joints far apart close over
                                    // several steps; contacts have Settings::depenetrationSpeed

/// Of the bodies whose turn it is, in a world's sub-step of h (s). seen: whether the velocities are
/// looked at before they are solved again, which can spare trees a solve (joint_nudges.h).
void solveNudges(std::span<Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h, bool seen);

}  // namespace engine
