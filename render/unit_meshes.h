/// Box, ball, dome and bar as triangles, without a driver.
#pragma once
#include <vector>

#include "render/vertex.h"

namespace render {

/// From -1 to 1 along every axis.
std::vector<Vertex> boxMesh();
/// Radius 1, with this many corners around, a multiple of 4.
std::vector<Vertex> ballMesh(int corners);
/// Half a ball, above y = 0: its rim is as round, its other triangles are twice as wide. Has no ends.
std::vector<Vertex> domeMesh(int corners);
/// Radius 1, with this many corners around, from y = -1 to 1, without ends.
std::vector<Vertex> barMesh(int corners);

}  // namespace render
