/// Step 3 of the loop as a black box: bodies and constraint rows in, impulses out, row by row, by the
/// method of the settings. Every method gets the same biases and bounces, and updates the same totals.
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

/// h: length of the sub-step, s. Sets report.trouble if the method cannot solve it.
void solveByMethod(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                      const Settings& settings, double h, StepReport& report);

}  // namespace engine
