/// Trails as bands of triangles that face the viewer.
#pragma once
#include <vector>

#include "render/camera.h"

namespace render {

struct TrailVertex {
    Eigen::Vector4f clip;
    Eigen::Vector4f color;  // sRGB, and how much it covers
};

std::vector<TrailVertex> trailBands(const Frame& frame, const View& view, int width, int height);

}  // namespace render
