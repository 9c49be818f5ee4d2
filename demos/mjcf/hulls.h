/// Convex hulls in place of shapes that this engine does not have.
#pragma once
#include <span>
#include <vector>

#include "engine/shape.h"

namespace demos::mjcf {

/// The hull of any number of points (m), about its own centre. If it has more corners than a shape
/// may have, only the points farthest out in 200 directions are used. Nothing for flat points.
std::optional<engine::Shape> hullOfAny(std::span<const engine::Vec3> points);

/// Corners of an ellipsoid with these half axes (m), whose hull has its volume.
std::vector<engine::Vec3> ellipsoidCorners(const engine::Vec3& halfAxes);

}  // namespace demos::mjcf
