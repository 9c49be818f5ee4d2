/// Step 3 of the loop as a black box: bodies and constraint rows in, impulses out, by the method of
/// the settings. Every method gets the same biases and bounces, and books the same totals.
#pragma once
#include "engine/solver/prepare.h"

namespace engine {

/// h: length of the sub-step, s. Sets report.trouble where a method has to refuse.
void solveConstraints(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                      const Settings& settings, double h, StepReport& report);

/// The same of a world's solver, which may hold its contacts in lanes.
void solveConstraints(Solver& solver, std::span<Velocity> v, const Settings& settings, double h,
                      StepReport& report);

}  // namespace engine
