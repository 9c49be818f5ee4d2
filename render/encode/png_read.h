/// PNG back to a picture: for tests, golden pictures and comparison.
#pragma once
#include <cstdint>
#include <span>

#include "render/image.h"

namespace render {

/// Decodes one complete PNG of any kind to 8-bit RGBA; a file without alpha comes back opaque.
/// Throws Error when the file is torn, damaged, not a PNG, or larger than 16384 on a side.
Image decodePng(std::span<const std::uint8_t> bytes);

}  // namespace render
