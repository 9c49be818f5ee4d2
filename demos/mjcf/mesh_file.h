/// Mesh files: corners, which a convex hull asks for, and triangles, to be drawn.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "demos/scene/description.h"

namespace demos::mjcf {

/// Wavefront OBJ (its lines `v x y z`) or binary STL, by the ending of `name`. Where there are no
/// corners, `wrong` says why, in one sentence.
struct MeshCorners {
    std::vector<Vec3> corners;
    std::vector<std::array<int, 3>> triangles;  // none where the file has no faces
    std::string wrong;
};
MeshCorners readMeshFile(const std::string& name, std::string_view bytes);

}  // namespace demos::mjcf
