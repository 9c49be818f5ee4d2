/// A camera as rays through the points of a picture.
#pragma once
#include "render/camera.h"

namespace render {

/// The ray through the point (x, y) of the picture, in pixels from the top left corner:
/// eye + t (ahead + x right + y down).
struct Sight {
    Vec3 eye{0, 0, 0};                                // m
    Vec3 ahead{0, 0, 0}, right{0, 0, 0}, down{0, 0, 0};  // m per pixel at 1 m; `ahead`: to (0, 0)
};
Sight sightOf(const View& view, int width, int height);

}  // namespace render
