/// Where two runs of one scene part.
#pragma once
#include "demos/regression/trajectory.h"
#include "demos/regression/verdict.h"

namespace demos {

/// Compares what both have: the bits of every step, and poses in the moments that both recorded. A
/// body that only one of them has is a change of physics too.
PhysicsVerdict diverge(const Trajectory& baseline, const Trajectory& actual,
                       const Tolerance& tolerance);

}  // namespace demos
