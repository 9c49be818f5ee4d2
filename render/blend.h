/// Blends one colour over one pixel.
#pragma once
#include <cstdint>

#include "render/frame.h"

namespace render {

/// Blends in sRGB, as is usual for text and flat marks. `cover`: 0..1, times the colour's alpha.
/// The pixel's alpha is not premultiplied.
inline void blend(std::uint8_t* pixel, const Color& color, float cover) {
    const float a = cover * color.a;
    if (a <= 0.0f) return;
    const float alpha = static_cast<float>(pixel[3]);
    const float after = alpha + (255.0f - alpha) * a;
    const float share = pixel[3] == 255 ? a : 255.0f * a / after;  // of the resulting colour
    const float over[3] = {color.r, color.g, color.b};
    for (int i = 0; i < 3; ++i) {
        const float under = static_cast<float>(pixel[i]);
        pixel[i] = static_cast<std::uint8_t>(under + (255.0f * over[i] - under) * share + 0.5f);
    }
    pixel[3] = static_cast<std::uint8_t>(after + 0.5f);
}

}  // namespace render
