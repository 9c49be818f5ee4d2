/// Compares the loads of two runs: what contacts and joints did to each body. Bodies at rest may
/// move alike under other loads, so poses do not show a changed mass or gravity.
///
///   load of a body in a step = the sum of the impulses of all its contacts and joints, N s
///
/// A heap may share its load among contacts in many ways, so contacts are not compared one by one; joints are, as
/// a heavy body hides what a rope does to it. Of sixteen recorded steps the sum counts, and an impact may come one
/// of them earlier or later:
///   least - allowed(least) <= sum <= most + allowed(most),   allowed(x) = larger(share x, floor) + rounding
/// least, most: the baseline's sums without the outermost steps and with one more on each side
/// floor: a tenth of the body's weight; for a joint a thousandth of that of its lighter body, for its torque (N m s)
///        at half the diagonal of that body's box
/// rounding: what the baseline's numbers have lost
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/regression/trajectory.h"

namespace demos {

struct LoadChange {
    int body = -1;                     // index in the baseline; of a joint: its lighter body
    std::string joint;                 // "joint NAME", "torque of joint NAME", or empty: the load of the body
    int first = 0, last = 0;           // steps
    double before = 0.0, after = 0.0;  // N or N m, means over these steps
    double used = 0.0;                 // the difference as a share of what is allowed
};

/// The earliest change beyond `share`, of the body or joint that is farthest beyond; nothing if there is
/// none. `places`: index in the actual run of each of the baseline's bodies, -1: missing; `steps`:
/// only before this one. Both have the same `dense`. A body without a mass is not compared.
std::optional<LoadChange> changedLoad(const Trajectory& baseline, const Trajectory& actual,
                                      const std::vector<int>& places, int steps, double share);

}  // namespace demos
