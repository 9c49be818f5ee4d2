/// The part of a picture that holds the bodies: only there are edges to smooth and corners to
/// darken.
#pragma once
#include "render/camera.h"

namespace render {

/// Pixels x0 <= x < x1, y0 <= y < y1, row 0 on top.
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    /// Wider by `border` on all sides, within a picture.
    PixelRect grown(int border, int width, int height) const;
};

/// Around all solids, rods and trails; the whole picture when one of them reaches behind the eye.
PixelRect bodiesRect(const Frame& frame, const View& view, int width, int height);

}  // namespace render
