// mission 26, 27: position errors, removed by nudges or by Baumgarte's bias.
#include <gtest/gtest.h>

#include "engine/dynamics/rotation.h"
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

/// A ball joint with its anchors `error` (m) apart, and nothing else.
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
    EXPECT_NEAR(world.pose({1}).position.x(), 0.016777, 5e-7);
    EXPECT_NEAR(world.pose({1}).position.x(), 0.1 * 0.16777216, 1e-12);
}

// mission 27: contacts get nudges too: the same decay for a ball 0.1 m deep in the floor
TEST(Nudges, TakeAnOverlapAwayInTheSameWay) {
    World world(seedWith(8, 0.2));
    world.setGravity(Vec3::Zero());
    world.add(support::floorPlane());
    const BodyId ball = world.add(body(Shape::sphere(0.5), {0, 0.4, 0}));
    world.step(kStep);
    EXPECT_NEAR(0.5 - world.pose(ball).position.y(), 0.016777, 5e-7);
    EXPECT_EQ(world.velocity(ball), Vec3(0, 0, 0));
}

// C and J are evaluated again in every sweep: a ball held at an arm of 0.8 m, on a rod that is too
// short, compared with a formula. With the first J in all eight sweeps the ball ends 6 mm away.
TEST(Nudges, EvaluateCAndJAnewInEverySweep) {
    World world(seedWith(8, 0.2));
    world.setGravity(Vec3::Zero());
    const BodyId top = world.add(support::hook());
    const BodyDef ball = body(Shape::sphere(0.5), {1.0, 0, 0}, 2.0);  // I = 2/5 m r^2 = 0.2
    JointDef rod;
    rod.type = JointType::distance;
    rod.a = top, rod.b = world.add(ball);
    rod.anchorB = {0, -0.8, 0}, rod.length = 0.9;
    world.add(rod);
    Vec3 x = ball.pose.position;
    Quat q = Quat::Identity();
    for (int sweep = 0; sweep < 8; ++sweep) {
        const Vec3 r = q * rod.anchorB, n = (x + r).normalized(), turn = r.cross(n);
        const double k = 1.0 / 2.0 + turn.squaredNorm() / 0.2;
        const double lambda = -0.2 * ((x + r).norm() - rod.length) / k;  // -beta C / K
        x += lambda / 2.0 * n;
        q = cayley(lambda / 0.2 * turn, q);
    }
    world.step(kStep);
    EXPECT_LT((world.pose(rod.b).position - x).norm(), 1e-12);
    EXPECT_LT((world.pose(rod.b).rotation * rod.anchorB - q * rod.anchorB).norm(), 1e-12);
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

// mission 26: b = beta C / dt: (1 - beta)^k; 0.2 gives 0.167772 after 8 steps. For equality rows; a
// contact may not pull, keeps the speed of the first step and jumps (below).
TEST(Baumgarte, DecaysGeometrically) {
    Settings s = seedWith(0, 0.0);
    s.baumgarte = 0.2;
    s.warmStart = false;
    World world = drifted(s);
    run(world, 8);
    EXPECT_NEAR(world.pose({1}).position.x() / 0.1, 0.167772, 5e-7);
}

TEST(Baumgarte, DivergesAboveTwo) {
    Settings s = seedWith(0, 0.0);
    s.baumgarte = 2.1;
    s.warmStart = false;
    World world = drifted(s, 0.001);
    run(world, 30);
    EXPECT_NEAR(world.pose({1}).position.x(), 0.001 * std::pow(1.0 - 2.1, 30), 1e-12);  // x 17
}

/// Highest point, above its rest position, of a ball that starts 0.5 m deep in the floor.
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
    EXPECT_NEAR(highest(baumgarte), 1.348, 5e-4);
    EXPECT_LT(highest(Settings::seed()), 1e-6);
    EXPECT_LT(highest(Settings::steady()), 1e-6);
}

}  // namespace
}  // namespace engine
