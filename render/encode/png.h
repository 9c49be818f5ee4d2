/// Encodes pictures as PNG, in memory. file.h writes them to disk: stb's own writer reports success
/// on a full disk.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/image.h"

namespace render {

inline constexpr int kLargestSide =
    16384;  // pixels; 4 * 16384^2 bytes still fit into stb's int

/// The bytes of a PNG file: RGB if every pixel is opaque, RGBA otherwise. `dpi`: pixels per inch on
/// paper, stored in the file (pHYs); 0: not stored.
/// Throws Error if a side is outside 1..16384 or the pixels do not fill the picture.
std::vector<std::uint8_t> encodePng(const Image& image, int dpi = 0);

/// True if `bytes` are one complete PNG of this size: signature, IHDR, the CRC of every chunk,
/// IEND last and nothing after it. Does not decompress: a resumed run checks every frame.
bool pngIsWhole(std::span<const std::uint8_t> bytes, int width, int height);

/// Throws Error unless both sides are within 1..16384 and `image.pixels` has the right length.
void checkSize(const Image& image);

}  // namespace render
