/// Encodes a trajectory in few bytes. Every number is stored in steps of its resolution, as its
/// difference from a prediction by the numbers before it,
///   r_k = round(x_k / resolution - g_k),  g_k = n_(k-1)  or  2 n_(k-1) - n_(k-2),  n_k = g_k + r_k
/// which is 0 for a body at rest or in uniform motion and small for a falling one; zlib compresses
/// the result.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "demos/regression/trajectory.h"
#include "demos/scene/description.h"

namespace demos {

/// Ten times finer than the scene's tolerances; for impulses and energy a ten-thousandth of the
/// largest value.
TrajectoryResolution resolutionOf(const Trajectory& trajectory, const Tolerance& tolerance);

/// The same trajectory with fewer moments; it keeps the hashes of all steps, and a moment has the
/// impulses of those before it that were left out. `dense`: at most that of `trajectory`.
Trajectory thinned(const Trajectory& trajectory, int dense);

/// Leaves out moments to reach at most `most` bytes, if that is possible.
std::vector<std::uint8_t> encodeTrajectory(const Trajectory& trajectory,
                                           const TrajectoryResolution& resolution,
                                           std::size_t most);

/// An older trajectory comes without masses, and with the impulses of its moments' own steps only.
/// Nothing if the bytes are not a trajectory: every length is checked before it is used.
std::optional<Trajectory> decodeTrajectory(std::span<const std::uint8_t> bytes);

}  // namespace demos
