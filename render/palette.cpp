#include "render/palette.h"

#include <array>

namespace render {

Color paletteColor(int index) {
    static constexpr std::array<Color, kPaletteSize> kColors{{
        {0.16f, 0.63f, 0.46f, 1.0f},  // bluish green
        {0.94f, 0.89f, 0.34f, 1.0f},  // yellow
        {0.40f, 0.72f, 0.90f, 1.0f},  // sky blue
        {0.90f, 0.64f, 0.22f, 1.0f},  // orange
        {0.82f, 0.51f, 0.67f, 1.0f},  // pink
        {0.84f, 0.40f, 0.20f, 1.0f},  // vermilion
        {0.19f, 0.48f, 0.73f, 1.0f},  // blue
    }};
    return kColors[((index % kPaletteSize) + kPaletteSize) % kPaletteSize];
}

Color darkGrey() { return {0.27f, 0.28f, 0.30f, 1.0f}; }
Color markerPink() { return {0.91f, 0.12f, 0.55f, 1.0f}; }
Color arrowRed() { return {0.80f, 0.05f, 0.05f, 1.0f}; }
Color nudgeBlue() { return {0.05f, 0.30f, 0.85f, 1.0f}; }

}  // namespace render
