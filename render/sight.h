/// A camera as rays: where a point of the picture looks.
#pragma once
#include "render/camera.h"

namespace render {

/// Ray to the point (x, y) of the picture, pixels from the top left corner:
/// eye + t (ahead + x right + y down).
struct Sight {
    Vec3 eye{0, 0, 0};                                // m
    Vec3 ahead{0, 0, 0}, right{0, 0, 0}, down{0, 0, 0};  // m a pixel at 1 m; `ahead`: to (0, 0)
};
Sight sightOf(const View& view, int width, int height);

}  // namespace render
