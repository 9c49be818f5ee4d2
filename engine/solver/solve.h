/// Step 3 of the loop: impulses until the constraints hold. The contacts are solved eight side by side
/// in single precision (wide/wide_contacts.h), joints in double: an island after the other, each swept
/// until it is satisfied, so that a heap at rest does not pay for one that is falling. What cannot be
/// done in lanes (Settings::usesLanes) goes row by row (methods.h).
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// h: length of the world's sub-step, s. Sets report.trouble where a method has to refuse.
void solveConstraints(Solver& solver, std::span<Velocity> v, const Settings& settings, double h,
                      StepReport& report);

/// One solve is enough for the joints: there is nothing but trees, and no contact on them.
bool solvedAtOnce(const Solver& solver);

}  // namespace engine
