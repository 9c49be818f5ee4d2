// mission 28: constraints that contradict each other settle between what they want (second seed).
#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

/// A ball that two ball joints want at x = +reach and at x = -reach (m), the first one first.
World tornBall(const Settings& settings, double reach) {
    World world(settings);
    world.setGravity(Vec3::Zero());
    const BodyId right = world.add(support::hook({reach, 0, 0}));
    const BodyId left = world.add(support::hook({-reach, 0, 0}));
    JointDef joint;
    joint.b = world.add(support::body(Shape::sphere(0.1), Vec3::Zero()));
    for (const BodyId hook : {right, left}) {
        joint.a = hook;
        world.add(joint);
    }
    return world;
}

double restOf(World& world) {
    support::run(world, 100);
    EXPECT_EQ(world.velocity({2}), Vec3(0, 0, 0));  // nudges are no velocity
    return world.pose({2}).position.x();
}

// x -> x + beta (1 - x) -> x + beta (-1 - x): what stays is -beta / (2 - beta) = -0.111111. At a
// tenth of the size: the engine moves a body by 0.2 m a nudge at most (nudges.cpp, kMostNudge).
TEST(Contradiction, SettlesWhereTheLastJointIsATouchNearer) {
    World world = tornBall(Settings::seed(), 0.1);
    EXPECT_NEAR(restOf(world) / 0.1, -0.2 / 1.8, 1e-12);
    EXPECT_NEAR(restOf(world) / 0.1, -0.111111, 5e-7);
}

// With 1 m either way beta C = 0.2 (1 -+ x) is more than the 0.2 m, and both pull alike.
TEST(Contradiction, SettlesInTheMiddleWhereBothNudgesAreCutOff) {
    World world = tornBall(Settings::seed(), 1.0);
    EXPECT_NEAR(restOf(world), 0.0, 1e-12);
}

// Every other share and any number of nudges a step end at the same place.
TEST(Contradiction, SettlesAtMinusBetaOverTwoLessBeta) {
    for (const double beta : {0.1, 0.3, 0.5, 0.9}) {
        Settings settings = Settings::seed();
        settings.nudgeFactor = beta;
        settings.nudges = 7;
        World world = tornBall(settings, 0.1);
        EXPECT_NEAR(restOf(world) / 0.1, -beta / (2.0 - beta), 1e-12) << beta;
    }
}

}  // namespace
}  // namespace engine
