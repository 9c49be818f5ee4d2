/// Box, ball and bar as triangles, without a driver.
#pragma once
#include <vector>

#include "render/vertex.h"

namespace render {

/// From -1 to 1 along every axis.
std::vector<Vertex> boxMesh();
/// Of radius 1 and of so many corners around; a multiple of 4.
std::vector<Vertex> ballMesh(int corners);
/// Of radius 1 and of so many corners around, from y = -1 to 1, without ends.
std::vector<Vertex> barMesh(int corners);

}  // namespace render
