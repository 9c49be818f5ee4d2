/// Box, ball and bar as triangles, without a driver.
#pragma once
#include <vector>

#include "render/vertex.h"

namespace render {

/// From -1 to 1 along every axis.
std::vector<Vertex> boxMesh();
/// Radius 1, with this many corners around, a multiple of 4.
std::vector<Vertex> ballMesh(int corners);
/// Radius 1, with this many corners around, from y = -1 to 1, without ends.
std::vector<Vertex> barMesh(int corners);

}  // namespace render
