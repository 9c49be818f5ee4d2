/// sRGB to linear light.
#pragma once
#include <cmath>

#include "render/frame.h"

namespace render {

/// r, g, b: 0..1 (IEC 61966-2-1).
inline Vec3 linear(const Color& color) {
    const auto decode = [](float s) {
        return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
    };
    return {decode(color.r), decode(color.g), decode(color.b)};
}

}  // namespace render
