/// The charts of a run that [look] plot, [[section]] plot and --what can name.
///
///   energy       J    kinetic, potential and their sum
///   penetration  mm   the deepest contact of the world
///   separation   mm   the largest separation of a joint
///   contacts          points that touch or may touch within the next step
///   impulse      N s  along the normal, of each of the contacts with the largest impulses
///   residual     m/s  the error left by the sweeps: sweep by sweep in the hardest sub-step, and
///                     after the last sweep of every step
#pragma once
#include <string>
#include <vector>

namespace demos {

/// Every name above, in this order.
const std::vector<std::string>& measureNames();

}  // namespace demos
