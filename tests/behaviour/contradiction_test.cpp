// mission 28: constraints that contradict each other settle between their targets (second seed).
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// A ball that two ball joints pull to x = +reach and to x = -reach (m), in this order.
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
    EXPECT_EQ(world.velocity({2}), Vec3(0, 0, 0));  // nudges add no velocity
    return world.pose({2}).position.x();
}

// x -> x + beta (1 - x) -> x + beta (-1 - x): the limit is -beta / (2 - beta) = -0.111111. At a tenth of the
// size, because the engine moves a body by at most 0.2 m per nudge (nudges.cpp, kMostNudge).
TEST(Contradiction, SettlesWhereTheLastJointIsATouchNearer) {
    World world = tornBall(Settings::seed(), 0.1);
    EXPECT_NEAR(restOf(world) / 0.1, -0.2 / 1.8, 1e-12);
    EXPECT_NEAR(restOf(world) / 0.1, -0.111111, 5e-7);
}

// With 1 m on both sides beta C = 0.2 (1 -+ x) exceeds the 0.2 m, and both pull equally.
TEST(Contradiction, SettlesInTheMiddleWhereBothNudgesAreCutOff) {
    World world = tornBall(Settings::seed(), 1.0);
    EXPECT_NEAR(restOf(world), 0.0, 1e-12);
}

// Any other share and any number of nudges per step end at the same place.
TEST(Contradiction, SettlesAtMinusBetaOverTwoLessBeta) {
    for (const double beta : {0.1, 0.3, 0.5, 0.9}) {
        Settings settings = Settings::seed();
        settings.nudgeFactor = beta;
        settings.nudges = 7;
        World world = tornBall(settings, 0.1);
        EXPECT_NEAR(restOf(world) / 0.1, -beta / (2.0 - beta), 1e-12) << beta;
    }
}

/// Eight links, straight from post to post, without slack: they can hardly correct errors along the chain.
struct TautChain {
    World world;
    BodyId right;
    std::vector<JointId> joints;

    explicit TautChain(const Settings& settings) : world(settings) {
        BodyId last = world.add(support::hook({-2, 3, 0}));
        for (int i = 0; i < 8; ++i) {
            BodyDef link = support::body(Shape::capsule(0.09, 0.5), {0.5 * i - 1.75, 3, 0}, 10.0);
            link.collide = false;
            link.pose.rotation = turnAboutXyz({0, 0, radians(90.0)});
            const BodyId next = world.add(link);
            joints.push_back(support::join(world, JointType::ball, last, next, {0.5 * i - 2.0, 3, 0}));
            last = next;
        }
        BodyDef post = support::hook({2, 3, 0});
        post.kind = BodyKind::kinematic;
        right = world.add(post);
        joints.push_back(support::join(world, JointType::ball, last, right, {2, 3, 0}));
    }
    double separation() const {
        double worst = 0.0;
        for (const JointId joint : joints) worst = larger(worst, world.joint(joint).separation);
        return worst;
    }
};

TEST(TautChain, HangsBetweenItsPosts) {
    for (const int nudges : {1, 30})
        for (const int hz : {60, 240}) {
            Settings settings = Settings::steady();
            settings.nudges = nudges;
            TautChain chain(settings);
            for (int i = 0; i < 3 * hz; ++i) {
                ASSERT_TRUE(chain.world.step(1.0 / hz)) << nudges << " nudges, step " << i;
                ASSERT_LT(chain.separation(), 1e-4) << nudges << " nudges, step " << i;
            }
        }
}

// Half a metre too far for two seconds, then back: it separates hardly more than necessary, and closes again.
TEST(TautChain, DrawnOutComesApartAndMends) {
    TautChain chain(Settings::steady());
    support::run(chain.world, 60);
    double worst = 0.0;
    for (const double speed : {0.5, 0.0, -0.5, 0.0}) {
        chain.world.setVelocity(chain.right, {speed, 0, 0}, Vec3::Zero());
        for (int i = 0; i < 60; ++i) {
            ASSERT_TRUE(chain.world.step(support::kStep)) << speed << ", step " << i;
            worst = larger(worst, chain.separation());
        }
    }
    EXPECT_GT(worst, 0.5 / 9);
    EXPECT_LT(worst, 2.0);
    support::run(chain.world, 60);
    EXPECT_LT(chain.separation(), 0.01);
}

}  // namespace
}  // namespace engine
