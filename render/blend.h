/// One colour over one pixel.
#pragma once
#include <cstdint>

#include "render/frame.h"

namespace render {

/// In sRGB, as text and flat marks are expected to look; `cover` 0..1 times the colour's own alpha.
inline void blend(std::uint8_t* pixel, const Color& color, float cover) {
    const float a = cover * color.a;
    if (a <= 0.0f) return;
    const float over[3] = {color.r, color.g, color.b};
    for (int i = 0; i < 3; ++i) {
        const float under = static_cast<float>(pixel[i]);
        pixel[i] = static_cast<std::uint8_t>(under + (255.0f * over[i] - under) * a + 0.5f);
    }
    const float alpha = static_cast<float>(pixel[3]);
    pixel[3] = static_cast<std::uint8_t>(alpha + (255.0f - alpha) * a + 0.5f);
}

}  // namespace render
