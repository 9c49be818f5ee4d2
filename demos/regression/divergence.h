/// Finds where two runs of one scene diverge.
#pragma once
#include "demos/regression/trajectory.h"
#include "demos/regression/verdict.h"

namespace demos {

/// Compares the bits of every step that both have, and the poses in the moments that both recorded;
/// where they agree, the loads of the bodies. A body that only one run has is also a change of
/// physics; another mass is reported.
PhysicsVerdict diverge(const Trajectory& baseline, const Trajectory& actual,
                       const Tolerance& tolerance);

}  // namespace demos
