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

/// One around every solid and rod in the picture; the whole picture for a body partly behind the
/// eye.
std::vector<PixelRect> bodyRects(const Frame& frame, const View& view, int width, int height);

/// The bounding rectangle of all of them.
PixelRect boundsOf(const std::vector<PixelRect>& rects);

/// The tiles of 8 x 8 pixels that a set of rectangles touches.
class Tiles {
public:
    Tiles(const std::vector<PixelRect>& rects, int width, int height);
    bool hold(int x, int y) const {
        return held_[static_cast<std::size_t>(y / kSide) * across_ + x / kSide] != 0;
    }

private:
    static constexpr int kSide = 8;  // pixels
    int across_;
    std::vector<char> held_;  // tile by tile, row by row
};

}  // namespace render
