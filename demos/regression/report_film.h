/// Two runs of a scene, thinned and rounded, as the report's scrubber draws them.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "demos/regression/report_page.h"

namespace demos {

/// null if there is no run. About `numbers` numbers at most: up to 120 moments of each run,
/// including the first that differs, and the bodies that move farthest. Positions are in multiples
/// of "unit" metres, rotations are (x, y, z) in multiples of 1/1000, w >= 0. Curves have up to 120
/// moments of their own; their penetration and separation are the largest since the previous one.
nlohmann::ordered_json filmOf(const ReportTrajectories& trajectories, const PhysicsVerdict& physics,
                              long numbers);

}  // namespace demos
