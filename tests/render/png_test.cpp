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

std::uint32_t bigEndian(const Bytes& bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 |
           bytes[at + 3];
}

TEST(Png, TellsItsPixelsAMetreWhereAsked) {
    const render::Image image = gradient(20, 10);
    const Bytes plain = render::encodePng(image), sized = render::encodePng(image, 300);
    ASSERT_EQ(sized.size(), plain.size() + 21);
    EXPECT_EQ(std::string(sized.begin() + 37, sized.begin() + 41), "pHYs");  // right after IHDR
    EXPECT_EQ(bigEndian(sized, 41), 11811u);  // 300 / 0.0254
    EXPECT_EQ(bigEndian(sized, 45), 11811u);
    EXPECT_EQ(sized[49], 1);  // metres
    EXPECT_TRUE(render::pngIsWhole(sized, 20, 10));  // and with it the chunk's CRC
    EXPECT_EQ(render::decodePng(sized).pixels, image.pixels);
    EXPECT_EQ(std::string(plain.begin(), plain.end()).find("pHYs"), std::string::npos);
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

TEST(Png, AnotherSizeIsRefusedBeforeThereIsRoomForIt) {
    const Bytes png = render::encodePng(gradient(61, 47));
    EXPECT_EQ(render::decodePng(png, 61, 47).width, 61);
    EXPECT_THROW(render::decodePng(png, 47, 61), render::Error);
    // Only a head: without the check of the size, it is truncated.
    Bytes head = render::encodePng(gradient(16384, 1));
    head.resize(40);
    try {
        render::decodePng(head, 160, 90);
        ADD_FAILURE() << "was read";
    } catch (const render::Error& error) {
        EXPECT_NE(std::string(error.what()).find("it is 16384x1, not 160x90"), std::string::npos)
            << error.what();
    }
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
