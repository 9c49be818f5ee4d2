/// What a picture shows, as numbers that line up with it pixel by pixel: how far, which way it
/// faces, which body, where it goes. Of the surface at the pixel's centre, computed in closed form
/// from the body's pose: a ball is round here, not made of triangles, and no value is the mean of
/// two bodies.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "render/camera.h"
#include "render/surface_map.h"

namespace render {

/// Which of the images are wanted.
struct DataPasses {
    bool depth = false, normal = false, id = false, flow = false;  // as in DataImages
    bool any() const { return depth || normal || id || flow; }  // at all
};

inline constexpr float kNoDepth = std::numeric_limits<float>::infinity();  // the sky
inline constexpr float kNoFlow = 1e10f;  // above 1e9 is 'unknown' in Middlebury's files

/// Row 0 on top; what was not asked for is empty.
struct DataImages {
    int width = 0, height = 0;          // pixels
    std::vector<float> depth;           // m along the view axis; kNoDepth: the sky
    std::vector<Vec3> normal;           // unit, world axes, towards the viewer; 0 0 0: the sky
    std::vector<std::uint16_t> id;      // id + 1 of the solid, rod or ground; 0: the sky
    std::vector<Eigen::Vector2f> flow;  // pixels, x right, y down; kNoFlow both: unknown
};

/// `map`: Renderer::surfaces(now). `next`: where everything is one frame later, for the flow; null:
/// the flow is unknown everywhere. The flow of a pixel is where the point seen there, carried by
/// its body, is in the next frame's picture, minus the pixel's centre, seen or hidden; of the sky,
/// points infinitely far away. Unknown where that is behind the camera, and for what is not there
/// in the next frame. Surfaces of two frames are matched by place and id. A rod is taken not to
/// twist, and to stretch evenly; a ground has no features, so it moves along its normal alone.
DataImages dataImages(const Frame& now, const Frame* next, const SurfaceMap& map,
                      const DataPasses& wanted);

/// The lens in pixels: a point (x, y, z) in eye axes is seen at
/// (centreX + focalX * x / -z, centreY - focalY * y / -z), the top left pixel's centre being at
/// (0.5, 0.5).
struct Lens {
    double focalX = 1, focalY = 1, centreX = 0, centreY = 0;  // pixels
};
/// Of a view in a picture of so many pixels.
Lens lensOf(const View& view, int width, int height);

}  // namespace render
