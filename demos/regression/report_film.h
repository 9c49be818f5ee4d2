/// Two runs of a scene, thinned and rounded, as what the report's scrubber draws.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "demos/regression/report_page.h"

namespace demos {

/// null where there is no run. At most `numbers` numbers, about: at most 120 moments of each run,
/// the first that differs among them, and of the bodies those that move farthest. Lengths of poses
/// are counts of "unit" metres, and rotations counts of 1/1000 of (x, y, z), w >= 0. Curves have up
/// to 120 moments of their own, penetration and separation the largest since the one before.
nlohmann::ordered_json filmOf(const ReportTrajectories& trajectories, const PhysicsVerdict& physics,
                              long numbers);

}  // namespace demos
