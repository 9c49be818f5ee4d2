/// The solids that a body's shape is drawn as: one, or one for every part of a compound.
#pragma once
#include <vector>

#include "engine/shape.h"
#include "render/frame.h"

namespace demos {

struct DrawnPart {
    render::Solid solid;  // not placed yet
    engine::Pose place;   // in the body's axes
};

/// Empty for a plane, which is drawn as a ground. Meshes are made here, once per body.
std::vector<DrawnPart> drawnParts(const engine::Shape& shape);

}  // namespace demos
