/// Depth, normal, body id and flow of every pixel of a picture. They describe the surface at the
/// pixel's centre and are computed in closed form from the body's pose: a ball is a true sphere,
/// not triangles, and no value is the mean of two bodies.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "render/camera.h"
#include "render/surface_map.h"

namespace render {

/// Which of the images to compute.
struct DataPasses {
    bool depth = false, normal = false, id = false, flow = false;  // as in DataImages
    bool any() const { return depth || normal || id || flow; }  // at all
};

inline constexpr float kNoDepth = std::numeric_limits<float>::infinity();  // the sky
inline constexpr float kNoFlow = 1e10f;  // above 1e9 is 'unknown' in Middlebury's files

/// Row 0 on top; images that were not requested are empty.
struct DataImages {
    int width = 0, height = 0;          // pixels
    std::vector<float> depth;           // m along the view axis; kNoDepth: the sky
    std::vector<Vec3> normal;           // unit, world axes, towards the viewer; 0 0 0: the sky
    std::vector<std::uint16_t> id;      // id + 1 of the solid, rod or ground; 0: the sky
    std::vector<Eigen::Vector2f> flow;  // pixels, x right, y down; kNoFlow both: unknown
};

/// `map`: Renderer::surfaces(now). `next`: the frame one later, for the flow; null: the flow is
/// unknown everywhere. The flow of a pixel is the position in the next picture of the point seen
/// there, moved with its body and visible or not, minus the pixel's centre. The sky's points are
/// infinitely far away. The flow is unknown where the point is behind the camera, and for surfaces
/// missing in the next frame. Surfaces of two frames are matched by index and id. A rod is assumed
/// not to twist and to stretch evenly; a ground has no features, so it moves only along its normal.
DataImages dataImages(const Frame& now, const Frame* next, const SurfaceMap& map,
                      const DataPasses& wanted);

/// The lens in pixels: a point (x, y, z) in eye axes appears at
/// (centreX + focalX * x / -z, centreY - focalY * y / -z); the top left pixel's centre is at
/// (0.5, 0.5).
struct Lens {
    double focalX = 1, focalY = 1, centreX = 0, centreY = 0;  // pixels
};
/// The lens of a view in a picture of this size.
Lens lensOf(const View& view, int width, int height);

}  // namespace render
