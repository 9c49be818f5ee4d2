/// Reads a PNG back into a picture: for tests, golden pictures and comparison.
#pragma once
#include <cstdint>
#include <span>

#include "render/image.h"

namespace render {

/// Decodes one complete PNG of any kind to 8-bit RGBA; a file without alpha comes back opaque.
/// `width`, `height` (pixels): of the picture that is wanted; 0: any. A file of a few bytes may
/// claim a gigabyte of pixels, so another size is refused before there is room for it.
/// Throws Error if the file is truncated, damaged, not a PNG, of another size, or has a side of
/// more than 16384 pixels.
Image decodePng(std::span<const std::uint8_t> bytes, int width = 0, int height = 0);

}  // namespace render
