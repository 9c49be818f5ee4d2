/// Axis-aligned boxes around shapes.
#pragma once
#include "engine/base/bounds.h"
#include "engine/shape.h"

namespace engine {

/// The bounds of any shape except a plane, which has none.
Bounds boundsOf(const Shape& shape, const Pose& pose);

/// The bounds of a box in other axes: they contain it, and are a little larger.
Bounds seenFrom(const Pose& pose, const Bounds& world);

}  // namespace engine
