/// Convex hulls of what this engine has no shape for.
#pragma once
#include <span>
#include <vector>

#include "engine/shape.h"

namespace demos::mjcf {

/// The hull of any number of points (m), centred on itself. With more corners than a shape may have
/// it is that of the points farthest out in 200 directions. Nothing where they are flat.
std::optional<engine::Shape> hullOfAny(std::span<const engine::Vec3> points);

/// Corners of an ellipsoid with these half axes (m), whose hull has its volume.
std::vector<engine::Vec3> ellipsoidCorners(const engine::Vec3& halfAxes);

}  // namespace demos::mjcf
