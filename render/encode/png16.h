/// 16-bit PNG, which stb cannot write: grey for depths and ids, RGB for normals.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace render {

/// The bytes of a PNG file of 16-bit samples; `channels`: 1 (grey) or 3 (RGB), row 0 on top.
/// Throws Error if a side is outside 1..16384 or the samples do not fill the picture.
/// PNG 1.2, sections 3 (chunks), 4.1 (IHDR, IDAT, IEND) and 6.2 (filter Sub).
std::vector<std::uint8_t> encodePng16(std::span<const std::uint16_t> samples, int width,
                                      int height, int channels);

}  // namespace render
