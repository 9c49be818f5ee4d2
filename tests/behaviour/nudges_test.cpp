// mission 26, 27: position errors, taken away by nudges or by Baumgarte's bias.
#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kStep;
using support::run;

Settings seedWith(int nudges, double factor) {
    Settings s = Settings::seed();
    s.nudges = nudges;
    s.nudgeFactor = factor;
    s.slop = 0.0;
    return s;
}

/// A ball joint with its anchors `error` (m) apart, nothing else.
World drifted(const Settings& settings, double error = 0.1) {
    World world(settings);
    world.setGravity(Vec3::Zero());
    const BodyId top = world.add(support::hook());
    const BodyId ball = world.add(body(Shape::sphere(0.1), {error, 0, 0}));
    JointDef joint;
    joint.a = top, joint.b = ball;
    world.add(joint);
    return world;
}

// 0.1 m of drift, beta 0.2, 8 sweeps: 0.1 (1 - 0.2)^8
TEST(Nudges, TakeAwayAShareInEverySweep) {
    World world = drifted(seedWith(8, 0.2));
    world.step(kStep);
    EXPECT_NEAR(world.pose({1}).position.x(), 0.016777216, 1e-12);
}

TEST(Nudges, LeaveVelocitiesAloneToTheBit) {
    World world = drifted(seedWith(8, 0.2));
    world.step(kStep);
    EXPECT_EQ(world.velocity({1}), Vec3(0, 0, 0));
    EXPECT_EQ(world.spin({1}), Vec3(0, 0, 0));
}

TEST(Nudges, PutATreeRightAtOnceAndItStaysStill) {
    Settings steady = Settings::steady();
    World world = drifted(steady);
    run(world, 2);
    EXPECT_NEAR(world.pose({1}).position.norm(), 0.0, 1e-12);
}

// mission 26: b = beta C / dt: (1 - beta)^k; 0.2 gives 0.167772 after 8 steps
TEST(Baumgarte, DecaysGeometrically) {
    Settings s = seedWith(0, 0.0);
    s.baumgarte = 0.2;
    s.warmStart = false;
    World world = drifted(s);
    run(world, 8);
    EXPECT_NEAR(world.pose({1}).position.x() / 0.1, 0.167772, 1e-6);
}

TEST(Baumgarte, DivergesAboveTwo) {
    Settings s = seedWith(0, 0.0);
    s.baumgarte = 2.1;
    s.warmStart = false;
    World world = drifted(s, 0.001);
    run(world, 30);
    EXPECT_GT(std::abs(world.pose({1}).position.x()), 0.01);  // 1.1^30 = 17
}

/// Highest point of a ball that starts 0.5 m deep in the floor, above its rest.
double highest(const Settings& settings) {
    World world(settings);
    world.add(support::floorPlane());
    const BodyId ball = world.add(body(Shape::sphere(1.0), {0, 0.5, 0}));
    double top = -1.0;
    for (int i = 0; i < 300; ++i) {
        world.step(kStep);
        top = larger(top, world.pose(ball).position.y() - 1.0);
    }
    return top;
}

// mission 27: with Baumgarte it jumps 1.348 m above the surface, with nudges never
TEST(DeepOverlap, JumpsWithBaumgarteAndRisesGentlyWithNudges) {
    Settings baumgarte = Settings::seed();
    baumgarte.nudges = 0;
    baumgarte.baumgarte = 0.2;
    EXPECT_NEAR(highest(baumgarte), 1.348, 0.002);
    EXPECT_LT(highest(Settings::seed()), 1e-6);
    EXPECT_LT(highest(Settings::steady()), 1e-6);
}

}  // namespace
}  // namespace engine
