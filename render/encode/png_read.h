/// Reads a PNG back into a picture: for tests, golden pictures and comparison.
#pragma once
#include <cstdint>
#include <span>

#include "render/image.h"

namespace render {

/// Decodes one complete PNG of any kind to 8-bit RGBA; a file without alpha comes back opaque.
/// Throws Error if the file is truncated, damaged, not a PNG, or has a side of more than 16384
/// pixels.
Image decodePng(std::span<const std::uint8_t> bytes);

}  // namespace render
