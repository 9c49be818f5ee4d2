/// The parts of a picture that hold bodies: only there are corners to darken.
#pragma once
#include <vector>

#include "render/camera.h"

namespace render {

/// Pixels x0 <= x < x1, y0 <= y < y1, row 0 on top.
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    /// Wider by `border` on all sides, within a picture.
    PixelRect grown(int border, int width, int height) const;
};

/// Around every solid and rod that is in the picture; the whole picture for one that lies on both
/// sides of the eye.
std::vector<PixelRect> bodyRects(const Frame& frame, const View& view, int width, int height);

/// Around all of them.
PixelRect boundsOf(const std::vector<PixelRect>& rects);

/// Rectangles of a picture, to the nearest 8 pixels outwards.
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
