/// Trails as bands of triangles that face the viewer, wider than the trail by half a pixel on
/// either side: there it covers pixels in part.
#pragma once
#include <vector>

#include "render/camera.h"

namespace render {

struct TrailVertex {
    Eigen::Vector4f clip;
    Eigen::Vector4f color;   // sRGB, and how much it covers
    Eigen::Vector2f across;  // pixels: from the trail's middle, and half its width
};

std::vector<TrailVertex> trailBands(const Frame& frame, const View& view, int width, int height);

}  // namespace render
