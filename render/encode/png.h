/// Pictures to PNG, in memory. Writing to disk is file.h: stb's own writer calls a full disk
/// success.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/image.h"

namespace render {

inline constexpr int kLargestSide =
    16384;  // pixels; 4 * 16384^2 bytes still fit the int stb counts in

/// The bytes of a PNG file: RGB when every pixel is opaque, RGBA otherwise. `dpi`: pixels an inch
/// on paper, which the file tells (pHYs); 0: it tells none.
/// Throws Error when a side is outside 1..16384 or the pixels do not fill the picture.
std::vector<std::uint8_t> encodePng(const Image& image, int dpi = 0);

/// True when `bytes` are one complete PNG of this size: signature, IHDR, the CRC of every chunk,
/// IEND last and nothing behind it. Does not decompress: a resumed run asks this of every frame.
bool pngIsWhole(std::span<const std::uint8_t> bytes, int width, int height);

/// Throws Error unless both sides are within 1..16384 and `image.pixels` holds them all.
void checkSize(const Image& image);

}  // namespace render
