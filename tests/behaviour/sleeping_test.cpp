// Islands fall asleep as a whole when they rest, and then stay where they are to the bit
// (engine/dynamics/sleep.h).
#include <gtest/gtest.h>

#include "tests/support/sleepers.h"

namespace engine {
namespace {

using namespace support;

TEST(Sleeping, IsOffByDefault) {
    World world = support::stack(5);
    run(world, 300);
    EXPECT_EQ(sleepers(world), 0);
    EXPECT_EQ(world.report().asleep, 0);
}

struct Way {
    const char* name;
    Settings settings;
};

std::ostream& operator<<(std::ostream& out, const Way& way) { return out << way.name; }

std::vector<Way> ways() {
    Way lanes{"lanes", sleepy()}, fast{"fast", sleepy(Settings::fast())}, rows{"rows", sleepy()};
    Way pgs{"pgs", sleepy()}, matrix{"matrix", sleepy()}, direct{"direct", sleepy()};
    Way seed{"seed", sleepy(Settings::seed())};
    rows.settings.lanes = false;
    pgs.settings.method = Method::pgs;
    matrix.settings.method = Method::pgsMatrix;
    direct.settings.method = Method::direct;
    return {lanes, fast, rows, pgs, matrix, direct, seed};
}

class SleepingStack : public testing::TestWithParam<Way> {};

TEST_P(SleepingStack, DoesNotMoveABitAndCarriesItsWeight) {
    World world = sleepingStack(4, GetParam().settings);
    EXPECT_EQ(world.report().asleep, 4);
    const std::uint64_t hash = world.hash();
    run(world, 300);
    EXPECT_EQ(world.hash(), hash);
    for (int i = 1; i <= 4; ++i) EXPECT_TRUE(world.velocity({i}).isZero(0.0));
    EXPECT_EQ(world.contacts().size(), 16u);
    EXPECT_EQ(world.errors().contacts, 16);
    EXPECT_GT(world.errors().penetration, 0.0);
    EXPECT_NEAR(loadOf(world), 4 * kMass * kGravity, 0.01 * 4 * kMass * kGravity);
    run(world, 1, 0.5 * kStep);  // a step of another length: the same force, half the impulse
    EXPECT_NEAR(loadOf(world, 0.5 * kStep), 4 * kMass * kGravity, 0.01 * 4 * kMass * kGravity);
}

TEST_P(SleepingStack, WakesWithTheImpulsesThatCarriedIt) {
    World world = sleepingStack(4, GetParam().settings);
    const double before = height(world, {4});
    world.setVelocity({4}, Vec3::Zero(), Vec3::Zero());
    EXPECT_EQ(sleepers(world), 0);
    run(world, 1);
    EXPECT_EQ(sleepers(world), 0);
    EXPECT_NEAR(loadOf(world), 4 * kMass * kGravity, 0.01 * 4 * kMass * kGravity);
    EXPECT_NEAR(height(world, {4}), before, 1e-4);  // without them it falls by 1 mm or more
    run(world, 60);
    EXPECT_EQ(sleepers(world), 4);
}

INSTANTIATE_TEST_SUITE_P(Ways, SleepingStack, testing::ValuesIn(ways()),
                         [](const auto& one) { return one.param.name; });

TEST(Sleeping, NeedsRestForAllOfSleepAfter) {
    Settings settings = sleepy();
    settings.sleepAfter = 2.0;
    World world = support::stack(1, settings);
    run(world, 119);
    EXPECT_EQ(sleepers(world), 0);
    run(world, 60);
    EXPECT_EQ(sleepers(world), 1);
}

TEST(Sleeping, IsOfIslands) {
    World world = sleepingStack(2);
    const BodyId far = world.add(body(kCube, {5, 0.5, 0}, kMass));
    run(world, 10);
    EXPECT_EQ(sleepers(world), 2);
    EXPECT_FALSE(world.isAsleep(far));
    for (int i = 0; i < 60; ++i) {
        world.applyForce(far, {0, 0, 100});  // too little to move it, but it counts as not resting
        world.step(kStep);
        ASSERT_FALSE(world.isAsleep(far));
    }
    EXPECT_EQ(sleepers(world), 2);
    world.remove(far);
    run(world, 1);
    EXPECT_EQ(sleepers(world), 2);
}

// A pendulum is slow at its turning points, but not for long: it swings as if sleeping were off.
TEST(Sleeping, APendulumNeverSleepsAtItsTurningPoint) {
    World world(sleepy()), other;
    for (World* w : {&world, &other}) {
        const BodyId top = w->add(support::hook());
        const BodyId bob = w->add(body(Shape::sphere(0.05), {std::sin(0.02), -std::cos(0.02), 0}));
        support::rod(*w, top, bob);  // 2 cm to either side
    }
    for (int i = 0; i < 1200; ++i) {
        world.step(kStep), other.step(kStep);
        ASSERT_EQ(sleepers(world), 0) << "step " << i;
    }
    EXPECT_EQ(world.hash(), other.hash());
}

// The plank could sleep without the ball that rolls on it.
TEST(Sleeping, IsOfAWholeIslandOrOfNone) {
    World world(sleepy());
    world.add(support::floorPlane());
    const BodyId plank = world.add(body(Shape::box({8, 0.5, 1}), {0, 0.25, 0}, kMass));
    BodyDef def = body(Shape::sphere(0.25), {-3, 0.75, 0});
    def.velocity = {0.5, 0, 0}, def.spin = {0, 0, -2};
    const BodyId ball = world.add(def);
    for (int i = 0; i < 300; ++i) {
        world.step(kStep);
        ASSERT_FALSE(world.isAsleep(plank) || world.isAsleep(ball)) << "step " << i;
    }
    EXPECT_GT(world.pose(ball).position.x(), -1.0);
}

TEST(Sleeping, ABarThatTurnsOnTheSpotDoesNotRest) {
    World world(sleepy());
    world.setGravity(Vec3::Zero());
    BodyDef def = body(Shape::capsule(0.1, 4.0), {0, 0, 0});
    def.spin = {0.05, 0, 0};  // 10 cm/s at its ends
    const BodyId bar = world.add(def), still = world.add(body(kCube, {9, 0, 0}));
    run(world, 120);
    EXPECT_FALSE(world.isAsleep(bar));
    EXPECT_TRUE(world.isAsleep(still));
}

TEST(Sleeping, ABallThatIsThrownUpDoesNotHangInTheAir) {
    World world(sleepy());
    BodyDef def = body(Shape::sphere(0.5), {0, 10, 0});
    def.velocity = {0, 5, 0};
    const BodyId ball = world.add(def);
    for (int i = 0; i < 60; ++i) {
        world.step(kStep);
        EXPECT_FALSE(world.isAsleep(ball));
    }
}

TEST(Sleeping, AForceFieldKeepsAllAwake) {
    World world = support::stack(1, sleepy());
    world.setForceField([](const World&, std::span<Load>) {});
    run(world, 120);
    EXPECT_EQ(sleepers(world), 0);
    world.setForceField({});
    run(world, 60);
    EXPECT_EQ(sleepers(world), 1);
}

TEST(Sleeping, BodiesThatAreJointedAsleepNoLongerCollide) {
    World world = sleepingStack(2);
    support::join(world, JointType::weld, {1}, {2}, {0, 1, 0});
    run(world, 1);
    for (const ContactState& c : world.contacts()) EXPECT_EQ(c.a.index, 0);
}

/// Links hanging straight down from a hook, asleep.
struct HangingChain {
    World world{sleepy()};
    BodyId hook, last;
    std::vector<JointId> joints;

    explicit HangingChain(JointType type) {
        hook = last = world.add(support::hook());
        for (int i = 0; i < 4; ++i) {
            const BodyId next = world.add(body(Shape::capsule(0.1, 0.5), {0, -0.5 * i - 0.25, 0}));
            joints.push_back(support::join(world, type, last, next, {0, -0.5 * i, 0}));
            last = next;
        }
        run(world, 120);
        EXPECT_EQ(sleepers(world), 4);
    }
};

// Without sweeps a joint's impulse is its start value.
TEST(Sleeping, JointsKeepTheirForceForAStepOfAnotherLength) {
    Settings settings = sleepy();
    settings.joints = JointSolving::rows;
    settings.substeps = settings.maxSubsteps = 1;
    World world(settings);
    const BodyId hook = world.add(support::hook());
    const BodyId ball = world.add(body(Shape::sphere(0.1), {0, -1, 0}));
    const JointId rod = support::rod(world, hook, ball);
    run(world, 60);
    EXPECT_TRUE(world.isAsleep(ball));
    run(world, 1, 0.25 * kStep);
    EXPECT_TRUE(world.isAsleep(ball));
    settings.sweeps = settings.minSweeps = 0;
    world.setSettings(settings);
    run(world, 1, 0.25 * kStep);
    EXPECT_NEAR(world.joint(rod).force.y(), kGravity, 1e-3);
}

class SleepingChain : public testing::TestWithParam<JointType> {};

TEST_P(SleepingChain, PullsAndFallsWithoutItsHook) {
    HangingChain chain(GetParam());
    const std::uint64_t hash = chain.world.hash();
    run(chain.world, 60);
    EXPECT_EQ(chain.world.hash(), hash);
    EXPECT_NEAR(chain.world.joint(chain.joints[0]).force.y(), 4 * kGravity, 0.05);
    chain.world.remove(chain.joints[0]);
    run(chain.world, 60);
    EXPECT_LT(height(chain.world, chain.last), -5.0);
}

TEST_P(SleepingChain, WakesAsAWhole) {
    HangingChain chain(GetParam());
    chain.world.applyImpulse(chain.last, {1, 0, 0}, chain.world.pose(chain.last).position);
    EXPECT_EQ(sleepers(chain.world), 0);
    run(chain.world, 1);
    EXPECT_NEAR(chain.world.joint(chain.joints[0]).force.y(), 4 * kGravity, 2.0);
    run(chain.world, 10);
    EXPECT_LT(chain.world.errors().separation, 1e-4);
    if (GetParam() == JointType::weld) return;  // holds still
    EXPECT_GT(chain.world.velocity(chain.last).norm(), 0.01);
}

TEST_P(SleepingChain, FollowsAHookThatIsMoved) {
    HangingChain chain(GetParam());
    chain.world.setPose(chain.hook, {{0, 0.05, 0}, Quat::Identity()});
    run(chain.world, 120);
    EXPECT_NEAR(height(chain.world, chain.last), -1.7, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Joints, SleepingChain,
                         testing::Values(JointType::ball, JointType::hinge, JointType::weld),
                         [](const auto& one) {
                             return one.param == JointType::ball    ? "ball"
                                    : one.param == JointType::hinge ? "hinge"
                                                                    : "weld";
                         });

/// Five stacks, hit by a ball one after the other while others sleep.
std::vector<std::uint64_t> hashesOf(const Settings& settings) {
    World world(settings);
    world.add(support::floorPlane());
    for (int k = 0; k < 5; ++k)
        for (int i = 0; i < 4; ++i) world.add(body(kCube, {3.0 * k, i + 0.5, 0.03 * i}, kMass));
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 420; ++i) {
        if (i % 70 == 60) {
            BodyDef ball = body(Shape::sphere(0.4), {3.0 * (i / 70), 2.5, -5}, kMass);
            ball.velocity = {0, 1, 15};
            world.add(ball);
        }
        world.step(kStep);
        hashes.push_back(world.hash() + 31 * sleepers(world));
    }
    EXPECT_GT(world.report().asleep, 0);
    return hashes;
}

TEST(Sleeping, GivesTheSameBitsInEveryRunAndOnAllInstructions) {
    Settings baseline = sleepy();
    baseline.instructions = Instructions::baseline;
    const std::vector<std::uint64_t> first = hashesOf(sleepy());
    EXPECT_EQ(first, hashesOf(sleepy()));
    EXPECT_EQ(first, hashesOf(baseline));
}

// A stack next to one that is hit keeps sleeping, and the hit one behaves as if it were alone.
TEST(Sleeping, ChangesNothingForThoseAwake) {
    World one(sleepy()), both(sleepy());
    both.add(support::floorPlane()), one.add(support::floorPlane());
    const BodyId far = both.add(body(kCube, {50, 0.5, 0}, kMass));
    run(both, 60), run(one, 60);
    EXPECT_TRUE(both.isAsleep(far));
    for (int i = 0; i < 6; ++i)
        for (World* w : {&one, &both}) w->add(body(kCube, {0.1 * i, 1.2 * i + 0.8, 0}, kMass));
    for (int i = 0; i < 90; ++i) {
        one.step(kStep), both.step(kStep);
        for (int k = 0; k < 6; ++k)
            ASSERT_EQ(one.pose({1 + k}).position, both.pose({2 + k}).position) << "step " << i;
    }
    EXPECT_TRUE(both.isAsleep(far));
}

/// Balls in a square of 4 by 4, joined along both sides, held at two corners, released level.
std::vector<BodyId> addNet(World& world) {
    std::vector<BodyId> net;
    const auto joint = [&](int a, int b) {
        const Vec3 middle = 0.5 * (world.pose(net[a]).position + world.pose(net[b]).position);
        support::join(world, JointType::ball, net[a], net[b], middle);
    };
    for (int i = 0; i < 16; ++i) {
        net.push_back(world.add(body(Shape::sphere(0.1), {0.5 * (i % 4), 5, 0.5 * (i / 4)})));
        if (i % 4 > 0) joint(i - 1, i);
        if (i >= 4) joint(i - 4, i);
    }
    for (const int corner : {0, 3}) {
        const Vec3 at = world.pose(net[corner]).position;
        support::join(world, JointType::ball, world.add(support::hook(at)), net[corner], at);
    }
    return net;
}

// The trees are rebuilt when a lamp on a chain falls asleep; this must not affect the net.
TEST(Sleeping, ChangesNothingForJointsThatPull) {
    World one(sleepy()), both(sleepy());
    const std::vector<BodyId> inOne = addNet(one), inBoth = addNet(both);
    const BodyId hook = both.add(support::hook({20, 5, 0}));
    const BodyId lamp = both.add(body(kCube, {20, 3, 0}));
    support::join(both, JointType::ball, hook, lamp, {20, 5, 0});
    for (int i = 0; i < 60; ++i) {
        one.step(kStep), both.step(kStep);
        for (std::size_t k = 0; k < inOne.size(); ++k)
            ASSERT_EQ(one.pose(inOne[k]).position, both.pose(inBoth[k]).position) << "step " << i;
    }
    EXPECT_TRUE(both.isAsleep(lamp));
    EXPECT_FALSE(both.isAsleep(inBoth[5]));
}

}  // namespace
}  // namespace engine
