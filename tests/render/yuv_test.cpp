#include "render/encode/yuv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Every pixel another colour, with the corners of the cube among them; alpha changes nothing.
render::Image colours(int width, int height) {
    render::Image image{width, height, Bytes(std::size_t{4} * width * height)};
    std::uint32_t state = 1;
    for (std::uint8_t& byte : image.pixels) {
        state = state * 1664525u + 1013904223u;
        const std::uint32_t value = state >> 24;
        byte = static_cast<std::uint8_t>(value < 40 ? 0 : value > 215 ? 255 : value);
    }
    return image;
}

struct Levels {
    double y, cb, cr;
};

/// ITU-R BT.709-6 in limited range, of sRGB values 0..255.
Levels formula(double r, double g, double b) {
    const double y = (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255.0;
    return {16.0 + 219.0 * y, 128.0 + 224.0 * (b / 255.0 - y) / 1.8556,
            128.0 + 224.0 * (r / 255.0 - y) / 1.5748};
}

TEST(Yuv, IsTheFormulaWithinALevel) {
    const int width = 62, height = 38;
    const render::Image image = colours(width, height);
    Bytes planes;
    render::toYuv420(image, planes);
    ASSERT_EQ(planes.size(), std::size_t{width * height * 3 / 2});
    const std::uint8_t* const cb = planes.data() + width * height;
    const std::uint8_t* const cr = cb + width * height / 4;
    double worst = 0.0, worstColour = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t* const p = image.at(x, y);
            worst = std::max(worst,
                             std::abs(planes[width * y + x] - formula(p[0], p[1], p[2]).y));
        }
    for (int y = 0; y < height; y += 2)
        for (int x = 0; x < width; x += 2) {
            double mean[3];
            for (int c = 0; c < 3; ++c)
                mean[c] = 0.25 * (image.at(x, y)[c] + image.at(x + 1, y)[c] +
                                  image.at(x, y + 1)[c] + image.at(x + 1, y + 1)[c]);
            const Levels exact = formula(mean[0], mean[1], mean[2]);
            const int at = width / 2 * (y / 2) + x / 2;
            worstColour = std::max({worstColour, std::abs(cb[at] - exact.cb),
                                    std::abs(cr[at] - exact.cr)});
        }
    EXPECT_LE(worst, 0.52);  // half a level of rounding, and 3/256 of products rounded down
    EXPECT_LE(worstColour, 0.52);
}

TEST(Yuv, GreysAreWithoutColourFromBlackToWhite) {
    render::Image image{2, 2, Bytes(16)};
    Bytes planes;
    for (int grey = 0; grey < 256; ++grey) {
        std::fill(image.pixels.begin(), image.pixels.end(), static_cast<std::uint8_t>(grey));
        render::toYuv420(image, planes);
        const auto y = static_cast<std::uint8_t>(std::lround(16.0 + 219.0 * grey / 255.0));
        EXPECT_EQ(planes, (Bytes{y, y, y, y, 128, 128})) << grey;
    }
}

}  // namespace
