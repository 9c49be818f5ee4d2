#include "render/difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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
    EXPECT_EQ(render::compare(a, grey(16, 16, 103), 3).worstWindow, 0);
    EXPECT_EQ(render::compare(a, grey(16, 16, 104), 3).worstWindow, 256);
    EXPECT_EQ(render::compare(a, grey(16, 16, 103), 2).worstWindow, 256);
    EXPECT_EQ(render::compare(a, grey(16, 16, 103), 3).differing, 256);
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
    EXPECT_LE(d.worstWindow, render::Gate{}.windowPixels);  // a thin scratch is below the limit
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

/// Counts every window pixel by pixel: the summed areas must agree with it.
int worstWindowOf(const render::Image& a, const render::Image& b, int levels) {
    int worst = 0;
    for (int top = 0; top == 0 || top + 16 <= a.height; ++top)
        for (int left = 0; left == 0 || left + 16 <= a.width; ++left) {
            int counted = 0;
            for (int y = top; y < std::min(top + 16, a.height); ++y)
                for (int x = left; x < std::min(left + 16, a.width); ++x) {
                    bool over = false;
                    for (int c = 0; c < 4; ++c)
                        over = over || std::abs(a.at(x, y)[c] - b.at(x, y)[c]) > levels;
                    counted += over;
                }
            worst = std::max(worst, counted);
        }
    return worst;
}

/// SSIM of one block by its definition: means first, then deviations from them.
double ssimOf(const render::Image& a, const render::Image& b, int left, int top) {
    const int right = std::min(left + 8, a.width), bottom = std::min(top + 8, a.height);
    const double count = (right - left) * (bottom - top);
    const auto sum = [&](auto value) {
        double total = 0.0;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) total += value(a.at(x, y), b.at(x, y));
        return total / count;
    };
    const auto luma = [](const std::uint8_t* p) {
        return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
    };
    const double meanA = sum([&](const auto* p, const auto*) { return luma(p); });
    const double meanB = sum([&](const auto*, const auto* q) { return luma(q); });
    const double covariance =
        sum([&](const auto* p, const auto* q) { return (luma(p) - meanA) * (luma(q) - meanB); });
    const double varianceA =
        sum([&](const auto* p, const auto*) { return std::pow(luma(p) - meanA, 2); });
    const double varianceB =
        sum([&](const auto*, const auto* q) { return std::pow(luma(q) - meanB, 2); });
    const double c1 = std::pow(0.01 * 255, 2), c2 = std::pow(0.03 * 255, 2);
    return (2 * meanA * meanB + c1) * (2 * covariance + c2) /
           ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

TEST(PictureDifference, AgreesWithItsDefinition) {
    std::mt19937 dice(7);  // the same numbers on every platform, unlike a distribution
    for (const auto& [width, height] : {std::pair{61, 37}, {16, 16}, {8, 50}, {3, 3}, {40, 9}}) {
        render::Image a = grey(width, height);
        for (std::uint8_t& value : a.pixels) value = static_cast<std::uint8_t>(dice() % 256);
        render::Image b = a;
        for (std::uint8_t& value : b.pixels)
            if (dice() % 9 == 0) value = static_cast<std::uint8_t>(value ^ (dice() % 16));
        double worst = 1.0;
        for (int y = 0; y < height; y += 8)
            for (int x = 0; x < width; x += 8) worst = std::min(worst, ssimOf(a, b, x, y));
        for (const int levels : {0, 4, 9})
            EXPECT_EQ(render::compare(a, b, levels).worstWindow, worstWindowOf(a, b, levels))
                << width << "x" << height << ", " << levels << " levels";
        EXPECT_NEAR(render::compare(a, b).worstSsim, worst, 1e-9) << width << "x" << height;
    }
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
