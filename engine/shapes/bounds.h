/// Axis-aligned boxes around shapes.
#pragma once
#include "engine/base/bounds.h"
#include "engine/shape.h"

namespace engine {

/// Of any shape but a plane, which has none.
Bounds boundsOf(const Shape& shape, const Pose& pose);

/// Of the same box seen in other axes: around it, and a little larger.
Bounds seenFrom(const Pose& pose, const Bounds& world);

}  // namespace engine
