#include "render/accumulator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace render {
namespace {

constexpr int kFine = 4096;  // steps of the inverse table; sRGB's darkest levels are 1/3294 apart

/// sRGB levels to linear light, 0..65535 (IEC 61966-2-1).
const std::array<std::uint16_t, 256>& lightOf() {
    static const std::array<std::uint16_t, 256> table = [] {
        std::array<std::uint16_t, 256> light{};
        for (int level = 0; level < 256; ++level) {
            const double s = level / 255.0;
            const double l = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
            light[level] = static_cast<std::uint16_t>(65535.0 * l + 0.5);
        }
        return light;
    }();
    return table;
}

/// The level nearest to a light value in `kFine` steps. It is found by counting up, so that every
/// level maps back to itself.
const std::array<std::uint8_t, kFine + 1>& levelOf() {
    static const std::array<std::uint8_t, kFine + 1> table = [] {
        std::array<std::uint8_t, kFine + 1> levels{};
        int level = 0;
        for (int i = 0; i <= kFine; ++i) {
            const double light = 65535.0 * i / kFine;
            while (level < 255 && light > 0.5 * (lightOf()[level] + lightOf()[level + 1])) ++level;
            levels[i] = static_cast<std::uint8_t>(level);
        }
        return levels;
    }();
    return table;
}

}  // namespace

Accumulator::Accumulator(int width, int height)
    : width_(width), height_(height), sums_(4 * static_cast<std::size_t>(width) * height) {}

void Accumulator::add(const Image& image) {
    const std::array<std::uint16_t, 256>& light = lightOf();
    const std::uint8_t* from = image.pixels.data();
    for (std::size_t i = 0; i < sums_.size(); i += 4) {
        const std::uint32_t cover = from[i + 3];
        for (std::size_t c = 0; c < 3; ++c)
            sums_[i + c] += cover == 255 ? light[from[i + c]] : light[from[i + c]] * cover / 255;
        sums_[i + 3] += cover * 257;
    }
    ++count_;
}

Image Accumulator::mean() const {
    const std::array<std::uint8_t, kFine + 1>& level = levelOf();
    Image image{width_, height_, std::vector<std::uint8_t>(sums_.size())};
    const double full = 65535.0 * std::max(count_, 1u);
    for (std::size_t i = 0; i < sums_.size(); i += 4) {
        const double cover = sums_[i + 3];
        const double scale = cover > 0.0 ? kFine / cover : 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels[i + c] =
                level[std::min(static_cast<int>(sums_[i + c] * scale + 0.5), kFine)];
        image.pixels[i + 3] = static_cast<std::uint8_t>(255.0 * cover / full + 0.5);
    }
    return image;
}

}  // namespace render
