// mission 34: J v2 = -e J v1, with a threshold.
#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kGravity;
using support::kStep;
using support::run;

/// Highest point after the first bounce of a ball dropped from 2 m (its lowest point).
double reboundHeight(double e, const Settings& settings) {
    World world(settings);
    BodyDef floor = support::floorPlane();
    world.add(floor);
    BodyDef ball = body(Shape::sphere(0.25), {0, 2.25, 0});
    ball.material.restitution = e;
    const BodyId id = world.add(ball);
    double highest = 0.0;
    bool bounced = false;
    for (int i = 0; i < 150; ++i) {
        world.step(kStep);
        bounced = bounced || world.velocity(id).y() > 0.0;
        if (bounced) highest = larger(highest, world.pose(id).position.y() - 0.25);
    }
    return highest;
}

TEST(Restitution, RisesToESquared) {
    for (const double e : {0.3, 0.5, 0.8, 1.0}) {
        EXPECT_NEAR(reboundHeight(e, Settings::steady()), 2.0 * e * e, 2e-3) << e;
        // Up to half a step's fall is lost or gained if the hit is between two steps.
        EXPECT_NEAR(reboundHeight(e, Settings::seed()), 2.0 * e * e, 0.25) << e;
    }
}

/// A ball dropped from a metre, for a minute: the height of every bounce, by its energy.
struct Bounces {
    std::vector<double> heights;  // m
    double lowest = 1.0;          // m, of its lowest point at ends of steps

    Bounces(double e, const Settings& settings) {
        World world(settings);
        world.add(support::floorPlane());
        BodyDef ball = body(Shape::sphere(0.25), {0, 1.25, 0}, 1.0);
        ball.material.restitution = e;
        const BodyId id = world.add(ball);
        double before = 0.0;
        for (int i = 0; i < 3600; ++i) {
            world.step(kStep);
            const double v = world.velocity(id).y();
            if (v > 0.0 && before <= 0.0)
                heights.push_back(world.energy().total() / kGravity - 0.25);
            before = v;
            lowest = smaller(lowest, world.pose(id).position.y() - 0.25);
        }
    }
};

TEST(Restitution, KeepsTheEnergyOfAMinuteOfBounces) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        const Bounces bounces(1.0, settings);
        EXPECT_GT(bounces.heights.size(), 60u);
        EXPECT_NEAR(bounces.heights.back(), 1.0, 1e-3);
        EXPECT_GT(bounces.lowest, -1e-4);
        EXPECT_LT(bounces.lowest, 1e-3);
    }
}

TEST(Restitution, RisesToEToTheTwiceNthAndComesToRest) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        const Bounces bounces(0.8, settings);
        ASSERT_GE(bounces.heights.size(), 8u);
        for (int n = 0; n < 8; ++n)
            EXPECT_NEAR(bounces.heights[n] / std::pow(0.64, n + 1), 1.0, 0.005) << n;
        EXPECT_GT(bounces.lowest, -6e-4);  // and rests on the floor at the end
    }
}

// A ball thrown at the floor slips, or grips and leaves rolling: mu (1 + e) v compared with 2/7 v.
TEST(Restitution, OfAnObliqueHitIsNewtonsAndCoulombs) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double v : {3.0, 10.0, 30.0, 100.0})
            for (const double mu : {0.0, 0.1, 0.8}) {
                World world(settings);
                world.setGravity(Vec3::Zero());
                BodyDef floor = support::floorPlane();
                floor.material.friction = mu;
                world.add(floor);
                BodyDef ball = body(Shape::sphere(0.25), {0, 1.25, 0}, 3.0);
                ball.material.restitution = 0.5, ball.material.friction = mu;
                ball.velocity = {v, -v, 0};
                const BodyId id = world.add(ball);
                run(world, 60);
                const double lost = smaller(mu * 1.5, 2.0 / 7.0) * v;
                EXPECT_NEAR(world.velocity(id).y() / v, 0.5, 5e-4) << v << ' ' << mu;
                EXPECT_NEAR(world.velocity(id).x() / v, 1.0 - lost / v, 5e-4) << v << ' ' << mu;
                EXPECT_NEAR(world.spin(id).z(), -2.5 * lost / 0.25, 5e-3 * v) << v << ' ' << mu;
            }
}

TEST(Restitution, SlowContactsDoNotBounce) {
    World world;
    world.add(support::floorPlane());
    BodyDef ball = body(Shape::sphere(0.25), {0, 0.252, 0});
    ball.material.restitution = 0.9;
    const BodyId id = world.add(ball);
    run(world, 60);
    EXPECT_LT(world.velocity(id).norm(), 1e-3);
    EXPECT_NEAR(world.pose(id).position.y(), 0.25, 1e-3);
}

TEST(Restitution, ABoxDroppedFlatStaysFlat) {
    World world;
    world.add(support::floorPlane());
    BodyDef box = body(Shape::box({1, 1, 1}), {0, 1.5, 0});
    box.material.restitution = 0.5;
    const BodyId id = world.add(box);
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        ASSERT_LT(world.spin(id).norm(), 2e-5);  // contacts are solved in single precision
    }
}

// One ball in, one ball out: for equal masses, momentum and energy allow nothing else.
TEST(Cradle, ABlowTravelsThroughARowOfTouchingBalls) {
    World world;
    world.setGravity(Vec3::Zero());
    for (int i = 0; i < 5; ++i) {
        BodyDef ball = body(Shape::sphere(0.25), {0.5 * i + (i > 0 ? 0.3 : 0.0), 0, 0});
        ball.material.restitution = 1.0;
        ball.material.friction = 0.0;
        if (i == 0) ball.velocity = {2, 0, 0};
        world.add(ball);
    }
    run(world, 30);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(world.velocity({i}).norm(), 0.0, 1e-9) << i;
    EXPECT_NEAR(world.velocity({4}).x(), 2.0, 1e-9);
}

TEST(Cradle, TwoBallsInTwoBallsOut) {
    World world;
    world.setGravity(Vec3::Zero());
    for (int i = 0; i < 5; ++i) {
        BodyDef ball = body(Shape::sphere(0.25), {0.5 * i + (i > 1 ? 0.3 : 0.0), 0, 0});
        ball.material.restitution = 1.0;
        ball.material.friction = 0.0;
        if (i < 2) ball.velocity = {2, 0, 0};
        world.add(ball);
    }
    run(world, 30);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(world.velocity({i}).norm(), 0.0, 1e-6) << i;
    for (int i = 3; i < 5; ++i) EXPECT_NEAR(world.velocity({i}).x(), 2.0, 1e-6) << i;
}

}  // namespace
}  // namespace engine
