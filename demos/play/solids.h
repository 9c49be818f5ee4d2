/// How a body's shape is drawn: as one solid, or for a compound one of every part.
#pragma once
#include <vector>

#include "engine/shape.h"
#include "render/frame.h"

namespace demos {

struct DrawnPart {
    render::Solid solid;  // at no place yet
    engine::Pose place;   // in the body's axes
};

/// Nothing for a plane, which is a ground. Meshes are made here, once for a body's life.
std::vector<DrawnPart> drawnParts(const engine::Shape& shape);

}  // namespace demos
