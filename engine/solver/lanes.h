/// Step 3 with the contacts eight side by side in single precision (wide/wide_contacts.h), joints in
/// double as always. An island after the other, each swept until it is satisfied: a heap at rest does
/// not pay for one that is falling.
#pragma once
#include "engine/solver/prepare.h"

namespace engine {

void solveInLanes(Solver& solver, std::span<Velocity> v, const Settings& settings, double h,
                  std::vector<SweepReport>& report);

/// One solve is enough for the joints: there is nothing but trees, and no contact on them.
bool solvedAtOnce(const Solver& solver);

/// One nudge of all contacts, unless none is needed. True: bodies were moved.
bool nudgeInLanes(Solver& solver, Bodies& bodies, const Settings& settings);

}  // namespace engine
