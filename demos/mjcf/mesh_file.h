/// Mesh files: vertices for a convex hull, and triangles to be drawn.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "demos/scene/description.h"

namespace demos::mjcf {

/// Wavefront OBJ or binary STL, by the extension of `name`. After an error `wrong` is not empty; it
/// says why, in one sentence.
struct MeshCorners {
    std::vector<Vec3> corners;
    std::vector<std::array<int, 3>> triangles;  // none if the file has no faces
    std::string wrong;
};
MeshCorners readMeshFile(const std::string& name, std::string_view bytes);

}  // namespace demos::mjcf
