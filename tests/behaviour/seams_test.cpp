// Floors of many pieces are smooth: bodies do not catch where one piece ends and the next begins.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/trigonometry.h"
#include "engine/world.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

constexpr int kTiles = 60;  // of 1 m, in a row along x

/// A flat mesh of 1 m by 0.7 m; `off`: how far its corners are displaced.
Shape flatMesh(double off) {
    support::Random random(3);
    constexpr int kRows = 12, kColumns = kTiles + 1;
    std::vector<Vec3> corners;
    std::vector<std::array<int, 3>> faces;
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i)
            corners.push_back({i - 0.5 * kTiles + off * random.number(-1, 1), 0.0,
                               0.7 * j - 4.0 + 0.7 * off * random.number(-1, 1)});
    for (int j = 0; j + 1 < kRows; ++j)
        for (int i = 0; i + 1 < kColumns; ++i) {
            const int a = j * kColumns + i, b = a + 1, c = a + kColumns, d = c + 1;
            if (random.number(0, 1) < 0.5) faces.push_back({a, c, b}), faces.push_back({b, c, d});
            else faces.push_back({a, c, d}), faces.push_back({a, d, b});
        }
    return Shape::meshOf(corners, faces);
}

BodyDef smooth(BodyDef def) {
    def.material.friction = 0.0;
    return def;
}

BodyDef tile(double x, double top = 0.0) {
    BodyDef def = support::fixed(Shape::box({1, 1, 8}));
    def.pose.position = {x, top - 0.5, 0};
    return smooth(def);
}

enum class Floor { regularMesh, irregularMesh, tiles, compound };

void addFloor(World& world, Floor floor) {
    if (floor == Floor::regularMesh) world.add(smooth(support::fixed(flatMesh(0.0))));
    if (floor == Floor::irregularMesh) world.add(smooth(support::fixed(flatMesh(0.22))));
    std::vector<ShapePart> parts;
    for (int i = 0; i < kTiles; ++i) {
        const BodyDef def = tile(i - 0.5 * kTiles + 0.5);
        if (floor == Floor::tiles) world.add(def);
        parts.push_back({def.shape, def.pose});
    }
    if (floor != Floor::compound) return;
    BodyDef def = smooth(support::fixed(Shape::compound(parts)));
    def.pose.position = {0, -0.5, 0};
    world.add(def);
}

struct Slider {
    Shape shape;
    double height;  // m, of its centre
    Quat turn = Quat::Identity();
};

std::vector<Slider> sliders() {
    std::vector<Vec3> drum;
    for (int i = 0; i < 8; ++i)
        for (const double y : {-0.15, 0.15})
            drum.push_back({0.5 * std::cos(0.785 * i), y, 0.5 * std::sin(0.785 * i)});
    return {{Shape::sphere(0.3), 0.3},
            {Shape::box({0.8, 0.4, 0.6}), 0.2},
            {Shape::capsule(0.2, 1.0), 0.2, Quat(std::sqrt(0.5), 0, 0, std::sqrt(0.5))},
            {Shape::cylinder(0.3, 0.4), 0.2},
            {Shape::cone(0.4, 0.8), 0.2},
            {*Shape::hullOf(drum), 0.15}};
}

struct Bumps {
    double speed = 0.0;   // a share of the slider's
    double height = 0.0;  // m
    double spin = 0.0;    // rad/s
};

/// The worst values of a slide over the whole floor, or during twenty seconds.
Bumps slide(Floor floor, const Slider& slider, double speed, const Settings& settings) {
    World world(settings);
    addFloor(world, floor);
    BodyDef def = smooth(support::body(slider.shape, {-25, slider.height, 0.13}));
    def.pose.rotation = Quat(std::cos(0.1), 0, std::sin(0.1), 0) * slider.turn;
    def.velocity = {speed, 0, 0};
    const BodyId id = world.add(def);
    Bumps worst;
    for (int i = 0; i < 1200 && world.pose(id).position.x() < 25; ++i) {
        world.step(support::kStep);
        const Vec3 lost = world.velocity(id) - Vec3(speed, 0, 0);
        worst.speed = std::max(worst.speed, lost.norm() / speed);
        worst.height =
            std::max(worst.height, std::abs(world.pose(id).position.y() - slider.height));
        worst.spin = std::max(worst.spin, world.spin(id).norm());
    }
    return worst;
}

class Seams : public testing::TestWithParam<Floor> {};

TEST_P(Seams, NothingCatches) {
    const std::vector<Slider> all = sliders();
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (std::size_t i = 0; i < all.size(); ++i)
            for (const double speed : {0.3, 3.0, 20.0, 60.0}) {
                const Bumps worst = slide(GetParam(), all[i], speed, settings);
                EXPECT_LT(worst.speed, 0.03) << i << ", " << speed;
                EXPECT_LT(worst.height, 0.2e-3) << i << ", " << speed;
                EXPECT_LT(worst.spin, 0.1) << i << ", " << speed;
            }
}

std::string nameOf(const testing::TestParamInfo<Floor>& floor) {
    const char* const names[] = {"regular_mesh", "irregular_mesh", "tiles", "compound"};
    return names[static_cast<int>(floor.param)];
}

INSTANTIATE_TEST_SUITE_P(Floors, Seams,
                         testing::Values(Floor::regularMesh, Floor::irregularMesh, Floor::tiles,
                                         Floor::compound),
                         nameOf);

/// A top with six sides, and a roof: along its ridge each corner rises by `bend` (rad) to both sides.
Shape hill(double bend, bool roof) {
    std::vector<Vec3> corners;
    std::vector<std::array<int, 3>> faces;
    if (roof) {
        corners = {{0, 0, -4}, {0, 0, 4}, {4, -4 * bend, -4}, {4, -4 * bend, 4}, {-4, -4 * bend, -4},
                   {-4, -4 * bend, 4}};
        faces = {{0, 1, 2}, {2, 1, 3}, {1, 0, 4}, {1, 4, 5}};
        return Shape::meshOf(corners, faces);
    }
    corners.push_back(Vec3::Zero());
    for (int i = 0; i < 6; ++i) {
        const double angle = kPi / 3 * i;
        corners.push_back({4 * std::cos(angle), -4 * bend, 4 * std::sin(angle)});
        faces.push_back({0, 1 + (i + 1) % 6, 1 + i});
    }
    return Shape::meshOf(corners, faces);
}

/// Over the top, a body is over no triangle: the nearest point is a corner or an edge, bent too little
/// to count as sharp.
TEST(Ridges, HoldWhatFallsOnThem) {
    for (const double degrees : {0.001, 0.1, 0.5, 1.0, 1.2, 1.4, 3.0, 10.0})
        for (const bool roof : {false, true})
            for (const Shape& shape : {Shape::sphere(0.3), Shape::sphere(2.0), Shape::capsule(0.5, 4.0)}) {
                const bool isBall = shape.type == ShapeType::sphere;
                const double half = isBall ? shape.radius : 2.0;
                for (const double speed : {1.0, 20.0, 200.0}) {
                    World world;
                    world.add(support::fixed(hill(radians(degrees), roof)));
                    BodyDef def = support::body(shape, {0, half + 1.234, 0});
                    def.velocity = {0, -speed, 0};
                    const BodyId body = world.add(def);
                    double lowest = half;
                    for (int i = 0; i < 60; ++i) {
                        world.step(support::kStep);
                        lowest = std::min(lowest, world.pose(body).position.y());
                    }
                    EXPECT_GT(lowest, half - 1e-3) << degrees << ' ' << roof << ' ' << half << ' ' << speed;
                }
            }
}

TEST(Steps, StopABoxAndLiftABall) {
    for (const double step : {0.005, 0.05}) {
        World world;
        for (int i = -5; i < 5; ++i) world.add(tile(i + 0.5, i < 0 ? 0.0 : step));
        const BodyId box =
            world.add(smooth(support::body(Shape::box({0.4, 0.4, 0.4}), {-1, 0.2, 2})));
        const BodyId ball = world.add(smooth(support::body(Shape::sphere(0.3), {-1, 0.3, -2})));
        world.setVelocity(box, {1, 0, 0}, Vec3::Zero());
        world.setVelocity(ball, {2, 0, 0}, Vec3::Zero());
        double highest = 0.0;
        for (int i = 0; i < 120; ++i) {
            world.step(support::kStep);
            highest = std::max(highest, world.pose(ball).position.y());
        }
        EXPECT_LT(world.velocity(box).x(), 0.1) << step;
        EXPECT_GT(highest, 0.3 + 0.9 * step) << step;
    }
}

TEST(Steps, APlankLiesOnTwoTrestles) {
    for (const double lower : {0.0, 1e-4, 5e-4}) {
        World world;
        world.add(tile(-2));
        world.add(tile(2, -lower));
        const BodyId plank = world.add(support::body(Shape::box({5.0, 0.1, 0.4}), {0, 0.05, 0}));
        for (int i = 0; i < 600; ++i) world.step(support::kStep);
        EXPECT_NEAR(world.pose(plank).position.y(), 0.05 - 0.5 * lower, 7e-4) << lower;
        EXPECT_LT(world.spin(plank).norm(), 1e-4) << lower;
    }
}

TEST(Steps, AWallOfTilesIsSmooth) {
    World world;
    world.setGravity({-5, -9.81, 0});
    for (int i = 0; i < 40; ++i) {
        BodyDef def = support::fixed(Shape::box({1, 1, 8}));
        def.pose.position = {-0.5, 0.5 - i, 0};
        world.add(smooth(def));
    }
    const BodyId box = world.add(smooth(support::body(Shape::box({0.4, 0.4, 0.4}), {0.2, 0, 0})));
    for (int i = 0; i < 120; ++i) world.step(support::kStep);
    EXPECT_NEAR(world.velocity(box).y(), -2 * 9.81, 0.02);
    EXPECT_NEAR(world.pose(box).position.x(), 0.2, 1e-3);
}

}  // namespace
}  // namespace engine
