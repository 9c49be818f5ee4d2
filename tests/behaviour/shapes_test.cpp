// Every kind of shape rests, stacks and slides as it should.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

Shape prism(int sides, double radius, double height) {
    std::vector<Vec3> points;
    for (int i = 0; i < sides; ++i)
        for (const double y : {-0.5 * height, 0.5 * height})
            points.push_back({radius * cosine(2.0 * kPi * i / sides), y,
                              radius * sine(2.0 * kPi * i / sides)});
    return *Shape::hullOf(points);
}

/// Four legs and a top, 0.8 m high.
Shape table() {
    std::vector<ShapePart> parts{{Shape::box({1.0, 0.1, 1.0}), {{0, 0.75, 0}, Quat::Identity()}}};
    for (const double x : {-0.4, 0.4})
        for (const double z : {-0.4, 0.4})
            parts.push_back({Shape::box({0.1, 0.7, 0.1}), {{x, 0.35, z}, Quat::Identity()}});
    return Shape::compound(parts);
}

/// A flat grid of `cells` by `cells` squares of 0.5 m, each of two triangles.
Shape flatGrid(int cells) {
    const std::vector<double> heights((cells + 1) * (cells + 1), 0.0);
    return Shape::heightField(cells + 1, cells + 1, 0.5, heights);
}

struct Stacked {
    const char* name;
    Shape shape;
    double height;  // m, of one
    double centre;  // m, above its lowest point
    Quat turn = Quat::Identity();
};

std::vector<Stacked> stackables() {
    const Quat lying = turnAbout(Vec3::UnitZ(), radians(90));
    const Shape t = table();
    return {{"cylinder", Shape::cylinder(0.4, 0.5), 0.5, 0.25},
            {"hexagon", prism(6, 0.5, 0.4), 0.4, 0.2},
            {"triangle", prism(3, 0.6, 0.5), 0.5, 0.25},
            {"table", t, 0.8, -t.origin.y()},
            {"sphere", Shape::sphere(0.5), 1.0, 0.5},
            {"capsule", Shape::capsule(0.3, 1.2), 0.6, 0.3, lying},
            {"log", Shape::cylinder(0.3, 1.2), 0.6, 0.3, lying},
            {"box", Shape::box({1, 0.6, 0.8}), 0.6, 0.3}};
}

class Stacks : public testing::TestWithParam<int> {};

TEST_P(Stacks, OfTenStandOnAPlaneAndOnAMesh) {
    const Stacked s = stackables()[GetParam()];
    for (const bool mesh : {false, true}) {
        World world;
        world.add(mesh ? support::fixed(flatGrid(9)) : support::floorPlane());
        for (int i = 0; i < 10; ++i) {
            BodyDef def = support::body(s.shape, {0, i * s.height + s.centre, 0}, 10.0);
            def.pose.rotation = s.turn;
            world.add(def);
        }
        support::run(world, 600);
        for (int i = 0; i < 10; ++i) {
            const Vec3& p = world.pose({i + 1}).position;
            EXPECT_NEAR(p.y(), i * s.height + s.centre, 0.012) << s.name << ' ' << i << mesh;
            EXPECT_LT(std::abs(p.x()) + std::abs(p.z()), 5e-3) << s.name << ' ' << i << mesh;
            EXPECT_LT(world.velocity({i + 1}).norm(), 5e-3) << s.name << ' ' << i << mesh;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Stacks, testing::Range(0, 8));

/// Cones support loads on their tips: seven plates, each on three cones.
TEST(Cones, CarryPlatesOnTheirTips) {
    World world;
    world.add(support::floorPlane());
    for (int layer = 0; layer < 7; ++layer) {
        const double y = 0.45 * layer;
        for (int i = 0; i < 3; ++i)
            world.add(support::body(Shape::cone(0.2, 0.4),
                                    {0.5 * cosine(2.0 * kPi * i / 3), y + 0.1,
                                     0.5 * sine(2.0 * kPi * i / 3)}, 5.0));
        world.add(support::body(Shape::cylinder(0.8, 0.05), {0, y + 0.425, 0}, 5.0));
    }
    support::run(world, 600);
    for (int layer = 0; layer < 7; ++layer) {
        const BodyId plate{4 * layer + 4};
        EXPECT_NEAR(world.pose(plate).position.y(), 0.45 * layer + 0.425, 0.012) << layer;
        EXPECT_LT(world.velocity(plate).norm(), 5e-3) << layer;
    }
}

TEST(Meshes, ABoxSlidesOverTheEdgesOfAFlatGridAsOverAPlane) {
    World world;
    BodyDef ground = support::fixed(flatGrid(40));
    ground.material.friction = 0.0;
    world.add(ground);
    const BodyId box = world.add(support::body(Shape::box({0.6, 0.4, 0.6}), {-8, 0.1995, 0.13}));
    world.setVelocity(box, {3.0, 0, 0.7}, Vec3::Zero());
    for (int i = 0; i < 300; ++i) {
        world.step(support::kStep);
        ASSERT_NEAR(world.pose(box).position.y(), 0.1995, 1e-3) << i;
    }
    EXPECT_NEAR(world.velocity(box).x(), 3.0, 1e-6);
    EXPECT_NEAR(world.velocity(box).z(), 0.7, 1e-6);
    EXPECT_LT(world.spin(box).norm(), 1e-5);
}

TEST(Meshes, ABallRollsOverAFlatGridWithoutABump) {
    World world;
    world.add(support::fixed(flatGrid(40)));
    const BodyId ball = world.add(support::body(Shape::sphere(0.3), {-8, 0.2995, 0.1}));
    world.setVelocity(ball, {3.0, 0, 0.4}, {0.4 / 0.3, 0, -3.0 / 0.3});
    for (int i = 0; i < 300; ++i) {
        world.step(support::kStep);
        ASSERT_NEAR(world.pose(ball).position.y(), 0.2995, 1e-3) << i;
    }
    EXPECT_NEAR(world.velocity(ball).x(), 3.0, 1e-3);
    EXPECT_NEAR(world.velocity(ball).z(), 0.4, 1e-3);
}

/// A valley along z: h = |x| slope; bodies dropped into it come to rest at the bottom.
TEST(Meshes, WhatIsDroppedIntoAValleyStaysInIt) {
    constexpr int kPoints = 21;
    std::vector<double> heights;
    for (int j = 0; j < kPoints; ++j)
        for (int i = 0; i < kPoints; ++i) heights.push_back(0.5 * 0.3 * std::abs(i - 10));
    World world;
    world.add(support::fixed(Shape::heightField(kPoints, kPoints, 0.3, heights)));
    const Shape dropped[] = {Shape::sphere(0.2), Shape::box({0.4, 0.3, 0.5}), prism(6, 0.3, 0.3),
                             Shape::capsule(0.15, 0.6), Shape::cylinder(0.2, 0.4)};
    for (int i = 0; i < 5; ++i)
        world.add(support::body(dropped[i], {0.9 - 0.4 * i, 2.0, 1.0 * (i - 2)}));
    support::run(world, 900);
    for (int i = 1; i <= 5; ++i) {
        const Vec3& p = world.pose({i}).position;
        EXPECT_LT(std::abs(p.x()), 0.6) << i;
        EXPECT_GT(p.y(), 0.05) << i;
        EXPECT_LT(p.y(), 0.8) << i;
    }
    EXPECT_LT(world.errors().penetration, 5e-3);
}

TEST(Meshes, HoldFromTheirFrontOnly) {
    World world;
    world.setGravity(Vec3::Zero());
    world.add(support::fixed(flatGrid(8)));
    const BodyId above = world.add(support::body(Shape::sphere(0.2), {0.1, 1, 0.1}));
    const BodyId below = world.add(support::body(Shape::sphere(0.2), {1.1, -1, 0.1}));
    world.setVelocity(above, {0, -2, 0}, Vec3::Zero());
    world.setVelocity(below, {0, 2, 0}, Vec3::Zero());
    support::run(world, 90);
    EXPECT_GT(world.pose(above).position.y(), 0.19);
    EXPECT_GT(world.pose(below).position.y(), 1.9);  // passed through
}

TEST(FastShapes, DoNotPassThroughAMesh) {
    const Shape thrown[] = {Shape::sphere(0.1), Shape::box({0.2, 0.1, 0.3}), prism(5, 0.15, 0.2),
                            Shape::cylinder(0.1, 0.3), Shape::cone(0.15, 0.3), table()};
    for (const Shape& shape : thrown)
        for (const double speed : {20.0, 80.0, 300.0}) {
            World world;
            world.add(support::fixed(flatGrid(8)));
            const BodyId body = world.add(support::body(shape, {0.13, 2.0, 0.21}));
            world.setVelocity(body, {0, -speed, 0}, {3, 1, 2});
            for (int i = 0; i < 30; ++i) {
                world.step(support::kStep);
                ASSERT_GT(world.pose(body).position.y(), -0.05) << speed << ' ' << i;
            }
        }
}

TEST(Compounds, OfTwoHalvesMoveLikeTheWhole) {
    const ShapePart halves[] = {{Shape::box({0.5, 0.4, 0.6}), {{0.75, 2, 0}, Quat::Identity()}},
                                {Shape::box({0.5, 0.4, 0.6}), {{0.25, 2, 0}, Quat::Identity()}}};
    World world;
    world.add(support::floorPlane());
    BodyDef whole = support::body(Shape::box({1.0, 0.4, 0.6}), {0, 1, 0}), two = whole;
    whole.mass.reset(), two.mass.reset();
    two.shape = Shape::compound(halves);
    two.pose.position = {5, 1, 0};
    whole.pose.rotation = two.pose.rotation = turnAboutXyz({0.3, 0.2, 0.1});
    const BodyId a = world.add(whole), b = world.add(two);
    EXPECT_LT((two.shape.origin - Vec3(-0.5, -2, 0)).norm(), 1e-12);
    EXPECT_NEAR(world.mass(a), world.mass(b), 1e-9);
    EXPECT_LT((world.inertia(a) - world.inertia(b)).norm(), 1e-9);
    support::run(world, 20);  // until just before the first corner touches
    EXPECT_LT((world.pose(a).position + Vec3(5, 0, 0) - world.pose(b).position).norm(), 1e-9);
    support::run(world, 600);
    for (const BodyId id : {a, b}) {
        EXPECT_NEAR(world.pose(id).position.y(), 0.2, 2e-3);
        EXPECT_LT(world.velocity(id).norm(), 1e-3);
    }
}

/// Down a slope without slipping: a = g sin(theta) / (1 + I / (m r^2)), 2/3 for a full cylinder.
TEST(Cylinders, RollDownASlopeAtTwoThirds) {
    const double theta = radians(20);
    World world;
    BodyDef slope = support::fixed(Shape::box({40, 1, 10}));
    slope.pose.rotation = turnAbout(Vec3::UnitZ(), -theta);
    slope.pose.position = slope.pose.rotation * Vec3(0, -0.5, 0);
    world.add(slope);
    BodyDef roller = support::body(Shape::cylinder(0.3, 1.0), Vec3::Zero());
    roller.pose.rotation = slope.pose.rotation * turnAbout(Vec3::UnitX(), radians(90));
    roller.pose.position = slope.pose.rotation * Vec3(-10, 0.2997, 0);
    const BodyId body = world.add(roller);
    support::run(world, 120);
    const Vec3 along = slope.pose.rotation * Vec3::UnitX();
    const double expected = 2.0 / 3.0 * support::kGravity * sine(theta) * 2.0;  // m/s after 2 s
    EXPECT_NEAR(world.velocity(body).dot(along), expected, 0.003 * expected);
    EXPECT_NEAR(-world.spin(body).z() * 0.3, expected, 0.005 * expected);
}

}  // namespace
}  // namespace engine
