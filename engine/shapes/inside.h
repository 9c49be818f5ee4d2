/// Tests whether a point is inside a shape.
#pragma once
#include "engine/shape.h"

namespace engine {

/// `p` in the shape's axes (m). A point less than `beyond` (m) outside counts as inside; a point on the
/// surface does not. Points below a plane are inside it; no point is inside a mesh.
bool isInside(const Shape& shape, const Vec3& p, double beyond = 0.0);

}  // namespace engine
