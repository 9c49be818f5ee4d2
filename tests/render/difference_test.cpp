#include "render/difference.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

render::Image grey(int width, int height, std::uint8_t level = 100) {
    render::Image image{width, height, {}};
    image.pixels.assign(std::size_t{4} * width * height, level);
    return image;
}

void paintSquare(render::Image& image, int left, int top, int side, std::uint8_t level) {
    for (int y = top; y < top + side; ++y) {
        for (int x = left; x < left + side; ++x) std::fill_n(image.at(x, y), 3, level);
    }
}

TEST(PictureDifference, OfAPictureAndItselfIsNothing) {
    const render::Difference d = render::compare(grey(40, 30), grey(40, 30));
    EXPECT_TRUE(d.sameSize);
    EXPECT_EQ(d.differing, 0);
    EXPECT_EQ(d.largest, 0);
    EXPECT_EQ(d.worstWindow, 0);
    EXPECT_DOUBLE_EQ(d.worstSsim, 1.0);
    EXPECT_TRUE(render::samePicture(d));
}

TEST(PictureDifference, CountsAndPlacesOnePixel) {
    const render::Image a = grey(40, 30);
    render::Image b = a;
    b.at(25, 20)[1] = 110;
    const render::Difference d = render::compare(a, b);
    EXPECT_EQ(d.differing, 1);
    EXPECT_EQ(d.largest, 10);
    EXPECT_EQ(d.worstWindow, 1);
    EXPECT_EQ(d.windowX, 10);  // the first 16 wide window that reaches column 25
    EXPECT_EQ(d.windowY, 5);
    EXPECT_LT(d.worstSsim, 1.0);
}

TEST(PictureDifference, LevelsAreExceededNotReached) {
    const render::Image a = grey(16, 16);
    EXPECT_EQ(render::compare(a, grey(16, 16, 103)).worstWindow, 0);
    EXPECT_EQ(render::compare(a, grey(16, 16, 104)).worstWindow, 256);
    EXPECT_EQ(render::compare(a, grey(16, 16, 103), 2).worstWindow, 256);
    EXPECT_EQ(render::compare(a, grey(16, 16, 103)).differing, 256);
}

TEST(PictureDifference, WindowsSlideOverEveryPosition) {
    const render::Image a = grey(64, 64);
    render::Image b = a;
    paintSquare(b, 25, 37, 4, 200);  // across the lines of a grid of 16 and of 8
    const render::Difference d = render::compare(a, b);
    EXPECT_EQ(d.worstWindow, 16);
    EXPECT_EQ(d.windowX, 13);
    EXPECT_EQ(d.windowY, 25);
}

TEST(PictureDifference, NoiseOfOneLevelPassesTheGate) {
    render::Image a = grey(64, 64);
    paintSquare(a, 16, 16, 20, 220);
    render::Image b = a;
    for (std::size_t i = 0; i < b.pixels.size(); i += 52) ++b.pixels[i];
    const render::Difference d = render::compare(a, b);
    EXPECT_GT(d.differing, 300);
    EXPECT_TRUE(render::samePicture(d)) << d.worstWindow << " " << d.worstSsim;
}

TEST(PictureDifference, ASquareShiftedByOnePixelFailsTheGate) {
    render::Image a = grey(320, 180), b = a;
    paintSquare(a, 100, 80, 20, 220);
    paintSquare(b, 101, 80, 20, 220);
    const render::Difference d = render::compare(a, b);
    EXPECT_EQ(d.differing, 40);  // one column gained, one lost: 0.07 % of the picture
    EXPECT_EQ(d.worstWindow, 16);
    EXPECT_FALSE(render::samePicture(d));
}

TEST(PictureDifference, StructureAloneFailsTheGate) {
    render::Image a = grey(32, 32), b = a;
    for (int i = 0; i < 8; ++i) b.at(8 + i, 8)[0] = b.at(8 + i, 8)[1] = 255;
    const render::Difference d = render::compare(a, b);
    EXPECT_LE(d.worstWindow, render::Gate{}.windowPixels);  // a thin scratch
    EXPECT_LT(d.worstSsim, 0.5);
    EXPECT_FALSE(render::samePicture(d));
}

TEST(PictureDifference, ColourAloneFailsTheGate) {
    render::Image a = grey(32, 32), b = a;
    // luma 0.299 R + 0.114 B stays: 38 levels of red less, 100 of blue more
    for (int i = 0; i < 9; ++i) {
        b.at(8 + i, 8)[0] = 62;
        b.at(8 + i, 8)[2] = 200;
    }
    const render::Difference d = render::compare(a, b);
    EXPECT_GT(d.worstSsim, 0.99);
    EXPECT_FALSE(render::samePicture(d));
}

TEST(PictureDifference, OfTwoSizesIsNeverTheSamePicture) {
    const render::Difference d = render::compare(grey(40, 30), grey(30, 40));
    EXPECT_FALSE(d.sameSize);
    EXPECT_FALSE(render::samePicture(d, {255, 1'000'000, -1.0}));
}

TEST(PictureDifference, PicturesSmallerThanAWindowAreOneWindow) {
    const render::Difference d = render::compare(grey(5, 3, 0), grey(5, 3, 255));
    EXPECT_EQ(d.worstWindow, 15);
    EXPECT_FALSE(render::samePicture(d));
}

}  // namespace
