/// The parts of a picture with bodies: only they need ambient occlusion.
#pragma once
#include <vector>

#include "render/camera.h"

namespace render {

/// Pixels x0 <= x < x1, y0 <= y < y1, row 0 on top.
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    /// Enlarged by `border` on all sides, clipped to the picture.
    PixelRect grown(int border, int width, int height) const;
};

/// The part of both.
PixelRect common(const PixelRect& a, const PixelRect& b);
/// The parts of `all` around a hole within it: above, below, left, right.
std::vector<PixelRect> around(const PixelRect& hole, const PixelRect& all);

/// One around every solid and rod in the picture; the whole picture for a body partly behind the
/// eye.
std::vector<PixelRect> bodyRects(const Frame& frame, const View& view, int width, int height);

/// The bounding rectangle of all of them.
PixelRect boundsOf(const std::vector<PixelRect>& rects);

}  // namespace render
