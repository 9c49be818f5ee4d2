// The parts of a picture that are computed without a driver: occlusion, means, samples, regions.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/accumulator.h"
#include "render/ground_corners.h"
#include "render/occlusion.h"
#include "render/tile_set.h"
#include "render/sampling.h"

namespace render {
namespace {

Image plain(std::uint8_t level, std::uint8_t alpha = 255) {
    Image image{2, 1, std::vector<std::uint8_t>(8, level)};
    image.pixels[3] = image.pixels[7] = alpha;
    return image;
}

TEST(Accumulator, EveryLevelComesBackAsItself) {
    for (int level = 0; level < 256; ++level) {
        Accumulator sum(2, 1);
        for (int i = 0; i < 3; ++i) sum.add(plain(static_cast<std::uint8_t>(level)));
        EXPECT_EQ(sum.mean().pixels, plain(static_cast<std::uint8_t>(level)).pixels) << level;
    }
}

TEST(Accumulator, TheMeanIsTakenOfLight) {
    Accumulator sum(2, 1);
    sum.add(plain(0));
    sum.add(plain(255));
    EXPECT_EQ(sum.mean().pixels[0], 188);  // half of the light in sRGB; half of the levels is 128
}

TEST(Accumulator, WhatIsNotThereHasNoColour) {
    Accumulator sum(2, 1);
    sum.add(plain(200));
    sum.add(plain(0, 0));
    EXPECT_EQ(sum.mean().pixels[0], 200);
    EXPECT_EQ(sum.mean().pixels[3], 128);
}

TEST(SubSample, CoversPixelSunAndLensEvenly) {
    const Vec3 sun = Vec3(0.45f, 0.75f, 0.5f).normalized();
    for (const int count : {1, 2, 7, 14, 16, 30}) {
        Eigen::Vector2f lens(0, 0);
        std::vector<int> turns(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            const SubSample sample = subSample(i, count, sun);
            EXPECT_LE(sample.pixel.cwiseAbs().maxCoeff(), 0.5f);
            EXPECT_NEAR(sample.toSun.norm(), 1.0f, 1e-5f);
            EXPECT_GT(sample.toSun.dot(sun), std::cos(0.036f));
            EXPECT_LE(sample.lens.norm(), 1.0f);
            lens += sample.lens / static_cast<float>(count);
            ++turns[static_cast<std::size_t>(sample.turn * static_cast<float>(count))];
        }
        for (const int times : turns) EXPECT_EQ(times, 1) << count;
        EXPECT_LT(lens.norm(), count >= 14 ? 0.2f : 1.0f) << count;
    }
}

/// Depths seen by a camera that looks along -z: a floor 1 m below it, and a wall 6 m away.
DepthMap room(bool wall) {
    DepthMap map{96, 96, std::vector<float>(96 * 96)};
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const float down = (static_cast<float>(y) + 0.5f) / 48.0f - 1.0f;  // tan of 45 degrees
            const float floor = down > 1e-3f ? 1.0f / down : 1000.0f;
            map.meters[static_cast<std::size_t>(96 * y + x)] =
                wall ? std::min(floor, 6.0f) : std::min(floor, 1000.0f);
        }
    return map;
}

OcclusionSettings everywhere(float reach) {
    OcclusionSettings settings;
    settings.reach = reach;
    settings.where = {{0, 0, 96, 96}};
    return settings;
}

constexpr int kCorner = 56;  // the row in which the wall meets the floor: tan = 1/6

TEST(Occlusion, APlaneSeesAllOfTheSky) {
    const ByteMap open = openness(room(false), everywhere(1.0f));
    for (int y = 60; y < 90; ++y) EXPECT_EQ(open.row(y)[48], 255) << y;
}

TEST(Occlusion, ACornerIsDarkerTheNearer) {
    const ByteMap open = openness(room(true), everywhere(2.0f));
    EXPECT_LT(open.row(kCorner + 1)[48], 235);
    EXPECT_LT(open.row(kCorner + 1)[48], open.row(kCorner + 6)[48]);
    EXPECT_GT(open.row(20)[48], 250);  // far up the wall
}

TEST(Occlusion, ManyRoughOnesAreLikeAFineOne) {
    const DepthMap map = room(true);
    const ByteMap fine = openness(map, everywhere(2.0f));
    double rough = 0.0;
    for (int i = 0; i < 16; ++i) {
        const ByteMap one =
            roughOpenness(map, everywhere(2.0f), (static_cast<float>(i) + 0.5f) / 16.0f);
        for (int x = 40; x < 56; ++x) rough += one.row(kCorner + 2)[x] / 256.0;
    }
    EXPECT_NEAR(rough, fine.row(kCorner + 2)[48], 12.0);
}

TEST(Occlusion, OutsideItsRegionAllIsOpen) {
    OcclusionSettings settings = everywhere(2.0f);
    settings.where = {{0, 0, 48, 96}};
    const ByteMap open = openness(room(true), settings);
    EXPECT_LT(open.row(kCorner + 1)[20], 255);
    EXPECT_EQ(open.row(kCorner + 1)[70], 255);
}

TEST(Occlusion, DoubledKeepsItsValuesAtAnySize) {
    const ByteMap map{2, 2, {0, 100, 100, 200}};
    for (const int side : {1, 4, 5}) {
        const ByteMap large = doubled(map, {0, 0, side, side});
        EXPECT_EQ(large.bytes.size(), static_cast<std::size_t>(side * side));
        EXPECT_EQ(large.row(0)[0], 0);
        EXPECT_EQ(large.row(side - 1)[side - 1], side > 1 ? 200 : 0);
    }
}

View straight() {
    Camera camera;
    camera.from = {0, 2, 8};
    camera.lookAt = {0, 0, 0};
    return makeView(camera, 16.0f / 9.0f);
}

TEST(BodyRects, HoldEveryCornerOfABody) {
    Frame frame;
    Solid box;
    box.position = {1, 0.5f, 0};
    box.rotation = Eigen::AngleAxisf(0.7f, Vec3(1, 1, 0).normalized());
    frame.solids.push_back(box);
    const View view = straight();
    ASSERT_EQ(bodyRects(frame, view, 640, 360).size(), 1u);
    const PixelRect rect = bodyRects(frame, view, 640, 360).front();
    const auto within = [](float place, int low, int high) {
        return place > static_cast<float>(low) && place < static_cast<float>(high);
    };
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 sign(corner & 1 ? 0.5f : -0.5f, corner & 2 ? 0.5f : -0.5f,
                        corner & 4 ? 0.5f : -0.5f);
        const Projected p = project(view, box.position + box.rotation * sign, 640, 360);
        EXPECT_TRUE(within(p.x, rect.x0, rect.x1) && within(p.y, rect.y0, rect.y1)) << corner;
    }
    EXPECT_LT(rect.x1 - rect.x0, 200);
}

TEST(BodyRects, AreThePictureWhereABodyReachesBehindTheEye) {
    Frame frame;
    Solid floor;
    floor.halfSize = {20, 0.1f, 20};
    frame.solids.push_back(floor);
    const PixelRect rect = boundsOf(bodyRects(frame, straight(), 640, 360));
    EXPECT_EQ(rect.x0 + rect.y0, 0);
    EXPECT_EQ(rect.x1, 640);
    EXPECT_EQ(rect.y1, 360);
    frame.solids[0].halfSize = {1, 1, 1};
    frame.solids[0].position = {0, 2, 12};  // entirely behind the eye
    EXPECT_TRUE(bodyRects(frame, straight(), 640, 360).empty());
}

TEST(TileSet, HoldAllPixelsOfTheirRectanglesAndFewMore) {
    TileSet tiles(37, 21, 8);
    tiles.add(PixelRect{3, 9, 20, 10});
    tiles.add(PixelRect{30, 0, 31, 21});
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 37; ++x) {
            const bool first = x < 24 && y >= 8 && y < 16, second = x >= 24 && x < 32;
            EXPECT_EQ(tiles.hold(x, y), first || second) << x << "," << y;
        }
}

TEST(Occlusion, IsTheSameInManyRectanglesAsInOne) {
    OcclusionSettings parts = everywhere(2.0f);
    parts.where = {{0, 0, 96, 50}, {0, 48, 50, 96}, {48, 48, 96, 96}};
    EXPECT_EQ(openness(room(true), parts).bytes, openness(room(true), everywhere(2.0f)).bytes);
}

/// Whether a point of the plane y = 0 lies in a triangle.
bool holds(const Vec3* t, const Vec3& p) {
    float sign = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const Vec3 side = t[(i + 1) % 3] - t[i], way = p - t[i];
        const float turn = side.z() * way.x() - side.x() * way.z();
        if (sign * turn < 0.0f) return false;
        if (turn != 0.0f) sign = turn;
    }
    return true;
}

int count(const std::vector<Vec3>& corners, const Vec3& point) {
    int found = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3) found += holds(&corners[i], point);
    return found;
}

TEST(GroundCorners, CoverThePlaneOnceWithAHoleForTheShadow) {
    const std::vector<Vec3> footprint = {{-2, 0, -1}, {3, 0, -2}, {4, 0, 2}, {-1, 0, 3}};
    const GroundCorners corners = groundCorners(Ground{}, straight(), footprint);
    std::minstd_rand random(3);
    int inside = 0;
    for (int i = 0; i < 300; ++i) {
        const auto coordinate = [&] {
            return static_cast<float>(random() % 20000) / 1000.0f - 10.003f;
        };
        const float x = coordinate();
        const Vec3 point(x, 0, coordinate());
        EXPECT_EQ(count(corners.inside, point) + count(corners.around, point), 1) << point;
        inside += count(corners.inside, point);
    }
    EXPECT_GT(inside, 3);
    EXPECT_EQ(groundCorners(Ground{}, straight(), {}).inside.size(), 0u);
}

}  // namespace
}  // namespace render
