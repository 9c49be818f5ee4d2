#include "render/encode/png.h"

#include <gtest/gtest.h>

#include "render/encode/png_read.h"
#include "render/error.h"

namespace {

using Bytes = std::vector<std::uint8_t>;

render::Image gradient(int width, int height, std::uint8_t alpha = 255) {
    render::Image image{width, height, Bytes(std::size_t{4} * width * height)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint8_t* pixel = image.at(x, y);
            pixel[0] = static_cast<std::uint8_t>(7 * x);
            pixel[1] = static_cast<std::uint8_t>(5 * y);
            pixel[2] = static_cast<std::uint8_t>(x * y);
            pixel[3] = alpha;
        }
    }
    return image;
}

constexpr std::size_t kColourType = 25;  // of a PNG file: 2 RGB, 6 RGBA

TEST(Png, ComesBackPixelForPixel) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {61, 47}, {640, 360}}) {
        const render::Image image = gradient(width, height);
        const render::Image back = render::decodePng(render::encodePng(image));
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        EXPECT_EQ(back.pixels, image.pixels);
    }
}

TEST(Png, DropsAlphaOnlyWhenEveryPixelIsOpaque) {
    render::Image image = gradient(20, 10);
    EXPECT_EQ(render::encodePng(image)[kColourType], 2);
    image.at(19, 9)[3] = 254;
    const Bytes png = render::encodePng(image);
    EXPECT_EQ(png[kColourType], 6);
    EXPECT_EQ(render::decodePng(png).pixels, image.pixels);
}

TEST(Png, IsTheSameFileEveryTime) {
    EXPECT_EQ(render::encodePng(gradient(64, 48)), render::encodePng(gradient(64, 48)));
}

TEST(Png, LongestSideIsAcceptedAndOneMoreIsNot) {
    const Bytes row = render::encodePng(gradient(16384, 1));
    EXPECT_TRUE(render::pngIsWhole(row, 16384, 1));
    EXPECT_THROW(render::encodePng(gradient(16385, 1)), render::Error);
    EXPECT_THROW(render::encodePng(gradient(1, 16385)), render::Error);
}

TEST(Png, RefusesPicturesWithoutPixels) {
    EXPECT_THROW(render::encodePng({}), render::Error);
    EXPECT_THROW(render::encodePng({-1, 4, {}}), render::Error);
    EXPECT_THROW(render::encodePng({4, 4, Bytes(63)}), render::Error);
}

TEST(Png, WholeMeansTheSizeAskedFor) {
    const Bytes png = render::encodePng(gradient(61, 47));
    EXPECT_TRUE(render::pngIsWhole(png, 61, 47));
    EXPECT_FALSE(render::pngIsWhole(png, 47, 61));
    EXPECT_FALSE(render::pngIsWhole({}, 61, 47));
}

TEST(Png, TornFilesAreSeen) {
    const Bytes png = render::encodePng(gradient(61, 47));
    for (std::size_t length = 0; length < png.size(); length += 97) {
        const Bytes torn(png.begin(), png.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_FALSE(render::pngIsWhole(torn, 61, 47)) << length << " bytes";
        EXPECT_THROW(render::decodePng(torn), render::Error) << length << " bytes";
    }
    Bytes allButOne = png;
    allButOne.pop_back();
    EXPECT_FALSE(render::pngIsWhole(allButOne, 61, 47));
    Bytes oneMore = png;
    oneMore.push_back(0);
    EXPECT_FALSE(render::pngIsWhole(oneMore, 61, 47));
}

TEST(Png, EveryFlippedByteIsSeen) {
    const Bytes png = render::encodePng(gradient(31, 17));
    for (std::size_t i = 0; i < png.size(); ++i) {
        Bytes damaged = png;
        damaged[i] ^= 0x10;
        EXPECT_FALSE(render::pngIsWhole(damaged, 31, 17)) << "byte " << i;
        EXPECT_THROW(render::decodePng(damaged), render::Error) << "byte " << i;
    }
}

}  // namespace
