/// Step 3 of the loop: impulses until the constraints hold. Contacts are solved eight at a time in single
/// precision (wide/wide_contacts.h), joints in double, one island after the other. Each is swept until it is
/// satisfied, so a resting heap needs no extra sweeps because of a falling one. Without lanes the contacts
/// are solved one by one in double (impulses.h); settings for which islands are not separate
/// (Settings::solvesByIsland) are in methods.h.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// h: length of the world's sub-step, s. Sets report.trouble if the method cannot solve it.
void solveConstraints(Solver& solver, Bodies& bodies, const Settings& settings, double h,
                      StepReport& report);

/// One solve is enough for a group: there are only trees, and no contacts on them.
bool solvedAtOnce(const Solver& solver, int group);

}  // namespace engine
