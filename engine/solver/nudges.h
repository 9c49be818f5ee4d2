/// Step 5 of the loop: correction nudges, impulses on positions (second seed).
///   lambda_n = -beta C / K,   x += M^-1 J^T lambda_n
/// with the same J and K as the impulses, C (and a joint's J) evaluated anew from the poses in every
/// sweep. What is taken away from an error this way never becomes velocity: a body pushed out of the floor does
/// not jump.
///
/// Trees of joints are put right as a whole (beta = 1), and theirs is the one exception to velocities
/// being left alone: v += M^-1 J^T lambda_n / h, and then J v = 0 once more at the new poses. That is
/// the RATTLE integrator (Andersen 1983); it keeps a pendulum's energy, of which 60 s of nudging alone
/// lose two thirds. It is faded out where an error is no longer small against the lever arm.
#pragma once
#include "engine/solver/prepare.h"

namespace engine {

/// h: length of the sub-step, s.
void solveNudges(std::span<const Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h);

}  // namespace engine
