#include "render/canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "render/overlay.h"

namespace render {
namespace {

constexpr Color kInk{0, 0, 0, 1};
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image white(int width, int height) {
    Image image;
    image.width = width, image.height = height;
    image.pixels.assign(4u * static_cast<std::size_t>(width) * height, 255);
    return image;
}

/// Black on white: the amount of ink, in pixels.
double inkOf(const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) sum += 255 - image.pixels[i];
    return sum / 255.0;
}

/// An 8-bit pixel is off by up to half a step; an edge has a few hundred of them.
constexpr double kRounding = 0.5;

TEST(Canvas, ARectangleHasItsAreaWhereverItLies) {
    for (const float shift : {0.0f, 0.25f, 0.5f, 0.9f}) {
        Image image = white(40, 30);
        fillRectangle(image, {5.0f + shift, 7.0f + shift}, 20.5f, 10.25f, kInk);
        EXPECT_NEAR(inkOf(image), 20.5 * 10.25, kRounding) << shift;
    }
}

/// Ink that half covers a transparent pixel keeps its colour at half the alpha: straight alpha.
TEST(Canvas, ATransparentPictureTakesTheInksColor) {
    Image image{4, 4, std::vector<std::uint8_t>(64, 0)};
    const Color ink{200 / 255.0f, 100 / 255.0f, 50 / 255.0f, 1.0f};
    fillRectangle(image, {1.5f, 1.0f}, 1.5f, 1.0f, ink);
    const std::vector<std::uint8_t> half(image.at(1, 1), image.at(1, 1) + 4);
    EXPECT_EQ(half, (std::vector<std::uint8_t>{200, 100, 50, 128}));
    EXPECT_EQ(image.at(2, 1)[3], 255);
    fillRectangle(image, {1.0f, 1.0f}, 1.0f, 1.0f, {0, 0, 0, 0.5f});  // a = 1/2 over b = 1/2
    EXPECT_NEAR(image.at(1, 1)[0], 200.0 / 3, 1.0);
    EXPECT_NEAR(image.at(1, 1)[3], 0.75 * 255, 1.0);
}

TEST(Canvas, AStraightLineHasItsAreaAtEveryWidth) {
    for (const double width : {0.4, 1.0, 2.0, 5.5})
        for (const float shift : {0.0f, 0.3f, 0.5f}) {
            Image image = white(120, 40);
            const Point points[] = {{10, 20 + shift}, {110, 20 + shift}};
            drawPolyline(image, points, static_cast<float>(width), kInk);
            const double ends = 0.25 * 3.14159 * width * width;  // two half discs
            EXPECT_NEAR(inkOf(image), 100.0 * width + ends, 1.0) << width << " " << shift;
        }
}

TEST(Canvas, ASlantedLineHasItsArea) {
    Image image = white(200, 200);
    const Point points[] = {{20, 30}, {170, 130}};
    drawPolyline(image, points, 3.0f, kInk);
    // The box filter is across the line instead of along the axes: an error of at most a percent.
    const double area = std::hypot(150.0, 100.0) * 3.0 + 0.25 * 3.14159 * 9.0;
    EXPECT_NEAR(inkOf(image), area, 0.01 * area);
}

TEST(Canvas, JointsOfATranslucentLineCountOnce) {
    Image whole = white(100, 20), cut = white(100, 20);
    const Color half{0, 0, 0, 0.5f};
    const Point two[] = {{10, 10}, {90, 10}};
    std::vector<Point> many;
    for (int i = 0; i <= 160; ++i) many.push_back({10.0f + 0.5f * static_cast<float>(i), 10.0f});
    drawPolyline(whole, two, 6.0f, half);
    drawPolyline(cut, many, 6.0f, half);
    EXPECT_EQ(whole.pixels, cut.pixels);
    for (const std::uint8_t value : cut.pixels) EXPECT_GE(value, 127);
}

TEST(Canvas, ATallLineHasNoSeams) {
    Image image = white(9, 300);  // more rows than are covered at a time
    const Point points[] = {{4.5f, -50}, {4.5f, 350}};
    drawPolyline(image, points, 3.0f, kInk);
    for (int y = 0; y < 300; ++y) EXPECT_EQ(image.at(4, y)[0], 0) << y;
    EXPECT_NEAR(inkOf(image), 900.0, kRounding);
}

TEST(Canvas, APointThatIsNotFiniteLeavesAGap) {
    Image image = white(100, 20);
    const Point points[] = {{10, 10}, {30, 10}, {kNan, 10}, {60, kInfinity}, {70, 10}, {90, 10}};
    drawPolyline(image, points, 2.0f, kInk);
    EXPECT_EQ(image.at(20, 10)[0], 0);
    EXPECT_EQ(image.at(50, 10)[0], 255);
    EXPECT_EQ(image.at(80, 10)[0], 0);
}

TEST(Canvas, APointAloneIsADot) {
    Image image = white(20, 20);
    const Point points[] = {{kNan, 0}, {10, 10}};
    drawPolyline(image, points, 8.0f, kInk);
    EXPECT_NEAR(inkOf(image), 3.14159 * 16.0, 1.0);
}

TEST(Canvas, WhatIsOutsideIsCutOffAndHarmless) {
    Image image = white(32, 32);
    const Point far[] = {{-1e30f, -1e30f}, {1e30f, 1e30f}, {1e38f, -1e38f}};
    drawPolyline(image, far, 2.0f, kInk);
    drawPolyline(image, far, kNan, kInk);
    drawPolyline(image, {}, 2.0f, kInk);
    fillRectangle(image, {-1e30f, 10}, 1e30f, 5, kInk);
    fillRectangle(image, {kNan, 10}, 4, 5, kInk);
    fillRectangle(image, {10, 10}, -4, 5, kInk);
    drawLabel(image, "far away", {1e30f, 10}, Anchor::start, 12, kInk);
    drawLabel(image, "nowhere", {kNan, 10}, Anchor::middle, 12, kInk);
    drawLabel(image, "across the edge", {-20, 34}, Anchor::start, 20, kInk);
    Image fresh = white(32, 32);
    const Point outside[] = {{-50, 5}, {-10, 60}, {90, 40}};
    drawPolyline(fresh, outside, 2.0f, kInk);
    EXPECT_EQ(inkOf(fresh), 0.0);
    Image none;
    drawPolyline(none, far, 2.0f, kInk);
    fillRectangle(none, {0, 0}, 4, 5, kInk);
    drawLabel(none, "nothing", {0, 0}, Anchor::end, 12, kInk);
}

/// First and last column with ink.
std::pair<int, int> extentOf(const Image& image) {
    int first = image.width, last = -1;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.at(x, y)[0] < 128) first = std::min(first, x), last = std::max(last, x);
    return {first, last};
}

TEST(Canvas, ALabelIsAnchoredAtItsStartMiddleOrEnd) {
    const float width = textWidth("height", 20);
    for (const auto& [anchor, left] :
         {std::pair{Anchor::start, 100.0f}, std::pair{Anchor::middle, 100.0f - 0.5f * width},
          std::pair{Anchor::end, 100.0f - width}}) {
        Image image = white(200, 40);
        drawLabel(image, "height", {100, 25}, anchor, 20, kInk);
        const auto [first, last] = extentOf(image);
        EXPECT_NEAR(first, left, 3.0f);  // a letter has a little room at its sides
        EXPECT_NEAR(last, left + width, 3.0f);
    }
}

TEST(Canvas, ALabelStandsOnItsBaselineWithoutAHalo) {
    Image image = white(80, 60);
    drawLabel(image, "H", {20, 40}, Anchor::start, 30, kInk);
    for (int x = 0; x < 80; ++x) EXPECT_EQ(image.at(x, 41)[0], 255);
    const auto [first, last] = extentOf(image);
    EXPECT_EQ(image.at(first + 1, 38)[0], 0);
    EXPECT_EQ(image.at(first - 2, 38)[0], 255);
    EXPECT_EQ(image.at(last + 2, 38)[0], 255);
}

}  // namespace
}  // namespace render
