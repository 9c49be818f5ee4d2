/// A drawn solid as triangles with shared vertices, as the renderer shows it, for other programs.
#pragma once
#include <cstdint>
#include <vector>

#include "render/frame.h"

namespace demos {

struct Triangles {
    std::vector<float> positions, normals;  // three per vertex; normals of length 1
    std::vector<std::uint32_t> corners;     // three per triangle, counter-clockwise from outside

    auto operator<=>(const Triangles&) const = default;
};

/// The solid divided by `scaleOf(solid)`: the same for all boxes, balls, cylinders and cones. A
/// capsule and a mesh are in metres.
Triangles trianglesOf(const render::Solid& solid);

/// m along the solid's axes; 1 for shapes that are in metres.
render::Vec3 scaleOf(const render::Solid& solid);

/// From -1 to 1 in x and z, facing up.
Triangles squareTriangles();

}  // namespace demos
