/// Nudges of joints.
///
/// Trees of joints are corrected as a whole (beta = 1), and only for them nudges change velocities. They
/// repeat the motion from the start of the sub-step with
///   v = v_0 + M^-1 J_0^T lambda,   lambda such that C(where v leads) = 0
/// found by Newton's method (two or three steps), and then J v = 0 once more at the new poses. This is the
/// RATTLE integrator (Andersen 1983; for rotations Leimkuhler and Reich, 'Simulating Hamiltonian Dynamics',
/// 8): it is symplectic, and its energy stays bounded for any time. With a single Newton step and a rotation
/// added to the pose it is not: five links gained 62 % in two minutes. The feedback is faded out where an
/// error is no longer small compared with the lever arm, undone where Newton's method does not converge, and
/// used only for trees that are solved exactly: feeding back the errors that the forests of a cloth leave
/// each other is unstable. Where Newton's method fails, as in chains that snap taut, the sub-step is repeated by
/// implicit Euler (tree_implicit.h), which loses energy and holds.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// Nudges all joints of a group once, after a sub-step of the world of h (s).
void nudgeJoints(std::span<const Joint> joints, Bodies& bodies, Solver& solver, int group,
                 const Settings& settings, double h, const TreeNudge& nudge);

/// Moves one body by a distance (m) and a rotation (rad), unless it is immovable.
void moveBy(const Velocity& way, int body, Bodies& bodies);

/// After the last nudge: prepares a group's joints at the new poses, and J v = 0 for trees. With only trees and
/// `seen` false, the latter is left to the next sub-step, at the same poses:  P (P v + h a) = P (v + h a).
void finishJoints(std::span<Joint> joints, Bodies& bodies, Solver& solver, int group, const Settings& settings,
                  bool seen);

}  // namespace engine
