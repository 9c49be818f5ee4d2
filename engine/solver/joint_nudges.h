/// Nudges of joints.
///
/// Trees of joints are put right as a whole (beta = 1), and theirs is the one exception to velocities
/// being left alone. From the start of the sub-step they move once more, with
///   v = v_0 + M^-1 J_0^T lambda,   lambda such that C(where v leads) = 0
/// found by Newton's method (two or three steps), and then J v = 0 once more at the new poses. That is
/// the RATTLE integrator (Andersen 1983; for rotations Leimkuhler and Reich, 'Simulating Hamiltonian
/// Dynamics', 8): it is symplectic, and energy stays within a bound for as long as one likes. With one
/// step of Newton's and a turn added to the rotation it is not: five links gained 62 % in two minutes.
/// It is faded out where an error is no longer small against the lever arm, taken back where Newton
/// gets nowhere, and only done for trees that are solved exactly: fed back, what the forests of a
/// cloth leave each other explodes.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// Nudges all joints once, after a sub-step of theirs of length h (s).
void nudgeJoints(std::span<const Joint> joints, Bodies& bodies, Solver& solver,
                 const Settings& settings, double h, const TreeNudge& nudge);

/// One body by a way (m) and a turn (rad), unless nothing can move it.
void moveBy(const Velocity& way, int body, Bodies& bodies);

/// After the last nudge: all joints at the new poses, and J v = 0 for trees. Unseen and with nothing
/// but trees that is left to the next sub-step, whose poses are the same:  P (P v + h a) = P (v + h a).
void finishJoints(std::span<Joint> joints, Bodies& bodies, Solver& solver,
                  const Settings& settings, bool seen);

}  // namespace engine
