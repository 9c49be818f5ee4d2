/// Trails as bands of triangles that face the viewer, half a pixel wider than the trail on either
/// side for the pixels it covers partly.
#pragma once
#include <vector>

#include "render/camera.h"

namespace render {

struct TrailVertex {
    Eigen::Vector4f clip;
    Eigen::Vector4f color;   // sRGB, and opacity
    Eigen::Vector2f across;  // pixels: from the trail's middle, and half its width
};

std::vector<TrailVertex> trailBands(const Frame& frame, const View& view, int width, int height);

}  // namespace render
