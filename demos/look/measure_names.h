/// What a run shows in numbers: the charts that [look] plot, [[section]] plot and --what can name.
///
///   energy       J    kinetic, potential and their sum
///   penetration  mm   the deepest contact of the world
///   separation   mm   the joint that is farthest apart
///   contacts          points that touch or may touch within the next step
///   impulse      N s  along the normal, of each of the contacts that got most
///   residual     m/s  what the sweeps leave: sweep by sweep in the sub-step that was hardest, and
///                     after the last sweep of every step
#pragma once
#include <string>
#include <vector>

namespace demos {

/// Every name above, in this order.
const std::vector<std::string>& measureNames();

}  // namespace demos
