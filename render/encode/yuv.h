/// From RGB to the planes that encoders of films take.
#pragma once
#include <cstdint>
#include <vector>

#include "render/image.h"

namespace render {

/// Replaces `planes` by the picture as Y'CbCr of BT.709 in limited range (16..235, 16..240), 4:2:0:
/// first Y, then Cb and Cr at half the size, each the mean of four pixels. Alpha is ignored. Whole
/// numbers only, so that every machine gives the same bytes; a value is within one level of the
/// formula. Both sides must be even. The buffer is kept, so that a film allocates it once.
void toYuv420(const Image& image, std::vector<std::uint8_t>& planes);

}  // namespace render
