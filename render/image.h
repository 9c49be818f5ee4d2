/// A picture in memory: 8-bit sRGB, RGBA, row 0 on top, no padding between rows.
#pragma once
#include <cstdint>
#include <vector>

namespace render {

/// `pixels` must have exactly width * height * 4 bytes: the functions that write files throw Error
/// otherwise.
struct Image {
    int width = 0, height = 0;         // pixels
    std::vector<std::uint8_t> pixels;  // width * height * 4 bytes, RGBA
    /// The four bytes of a pixel; x and y must be inside.
    const std::uint8_t* at(int x, int y) const { return pixels.data() + 4 * (y * width + x); }
    /// The same, writable.
    std::uint8_t* at(int x, int y) { return pixels.data() + 4 * (y * width + x); }
};

}  // namespace render
