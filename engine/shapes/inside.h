/// Whether a shape holds a point.
#pragma once
#include "engine/shape.h"

namespace engine {

/// `p` in the shape's axes (m). Less than `beyond` (m) outside counts as inside; on the surface does
/// not. A plane holds what lies below it, a mesh nothing.
bool isInside(const Shape& shape, const Vec3& p, double beyond = 0.0);

}  // namespace engine
