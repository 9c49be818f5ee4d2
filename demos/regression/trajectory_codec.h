/// A trajectory in few bytes. Every number is told in steps of its resolution, by how far it is
/// from where those before it lead,
///   r_k = round(x_k / resolution - g_k),  g_k = n_(k-1)  or  2 n_(k-1) - n_(k-2),  n_k = g_k + r_k
/// which is 0 for what rests or glides, and small for what falls; zlib does the rest.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "demos/regression/trajectory.h"
#include "demos/scene/description.h"

namespace demos {

/// Ten times finer than the scene's tolerances; of impulses and energy a ten-thousandth of the
/// largest.
TrajectoryResolution resolutionOf(const Trajectory& trajectory, const Tolerance& tolerance);

/// The same with fewer moments; the hashes of all steps stay. `dense`: no more than it has.
Trajectory thinned(const Trajectory& trajectory, int dense);

/// At most `most` bytes where leaving out moments can help.
std::vector<std::uint8_t> encodeTrajectory(const Trajectory& trajectory,
                                           const TrajectoryResolution& resolution,
                                           std::size_t most);

/// Nothing where the bytes are no trajectory: every length is checked before it is used.
std::optional<Trajectory> decodeTrajectory(std::span<const std::uint8_t> bytes);

}  // namespace demos
