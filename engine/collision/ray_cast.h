/// Where a straight way enters shapes, in closed form.
#pragma once
#include <optional>

#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

struct SurfaceHit {
    double fraction = 0.0;  // of the way
    Vec3 normal{0, 1, 0};   // unit, out of the shape, world axes
};

/// From `from` to `to` (m, world axes). None where the way begins inside, leads away, or ends before.
std::optional<SurfaceHit> enterShape(const Shape& shape, const Pose& pose, const Vec3& from,
                                     const Vec3& to);

}  // namespace engine
