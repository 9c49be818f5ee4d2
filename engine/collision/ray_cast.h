/// Where a ray enters a shape, in closed form.
#pragma once
#include <optional>

#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

struct SurfaceHit {
    double fraction = 0.0;  // of the ray
    Vec3 normal{0, 1, 0};   // unit, out of the shape, world axes
};

/// The ray goes from `from` to `to` (m, world axes). No hit if it begins inside, misses, or ends before the
/// shape.
std::optional<SurfaceHit> enterShape(const Shape& shape, const Pose& pose, const Vec3& from,
                                     const Vec3& to);

}  // namespace engine
