// A world that continues from a saved state has the bits of one that never stopped.
#include <gtest/gtest.h>

#include "tests/support/golden_worlds.h"

namespace engine {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes stateOf(const World& world) {
    Bytes bytes;
    world.saveState(bytes);
    return bytes;
}

bool sameContacts(const World& one, const World& other) {
    const std::vector<ContactState> a = one.contacts(), b = other.contacts();
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].a != b[i].a || a[i].position != b[i].position || a[i].impulse != b[i].impulse ||
            a[i].friction != b[i].friction || a[i].feature != b[i].feature)
            return false;
    return true;
}

/// The same world, with other threads, from the state of the first after `before` steps.
void goOn(const support::GoldenWorld& golden, int before, int steps, int threads) {
    World whole = golden.make(), rest = golden.make();
    support::run(whole, before);
    Settings settings = rest.settings();
    settings.threads = threads;
    rest.setSettings(settings);
    ASSERT_TRUE(rest.restoreState(stateOf(whole)));
    EXPECT_EQ(rest.hash(), whole.hash());
    EXPECT_EQ(rest.report().step, whole.report().step);
    EXPECT_EQ(rest.report().energy.total(), whole.report().energy.total());
    EXPECT_TRUE(sameContacts(whole, rest));
    support::run(whole, steps), support::run(rest, steps);
    EXPECT_EQ(rest.hash(), whole.hash()) << golden.name << ", step " << before;
    EXPECT_EQ(rest.touches().size(), whole.touches().size());
    EXPECT_TRUE(sameContacts(whole, rest));
    if (threads == 1) {  // threads add up the reports of their sweeps in another order
        EXPECT_EQ(stateOf(rest), stateOf(whole));
    }
}

class Keeping : public testing::TestWithParam<support::GoldenWorld> {};

TEST_P(Keeping, GoesOnToTheSameBits) {
    goOn(GetParam(), 0, 20, 1);
    goOn(GetParam(), 25, 30, 1);
    goOn(GetParam(), 70, 30, 2);
}

INSTANTIATE_TEST_SUITE_P(All, Keeping, testing::ValuesIn(support::goldenWorlds()),
                         [](const testing::TestParamInfo<support::GoldenWorld>& tested) {
                             return std::string(tested.param.name);
                         });

/// Boxes that fall asleep, a removed body whose number is used again, a motor set while it runs.
World eventful(int steps) {
    Settings settings;
    settings.sleeping = true;
    World world(settings);
    world.add(support::floorPlane());
    for (int i = 0; i < 6; ++i)
        world.add(support::body(Shape::box({1, 1, 1}), {3.0 * (i % 3), 0.5 + i / 3, 0}));
    const BodyId hook = world.add(support::hook({0, 6, 0}));
    const BodyId bob = world.add(support::body(Shape::sphere(0.2), {1, 6, 0}));
    JointDef def = support::jointAt(world, JointType::hinge, hook, bob, {0, 6, 0}, {0, 0, 1});
    const JointId hinge = world.add(def);
    for (int i = 1; i <= steps; ++i) {
        if (i == 10) world.remove(BodyId{5});
        if (i == 12) world.add(support::body(Shape::box({1, 1, 1}), {3.0, 3.5, 0.1}));
        Freedom driven;
        driven.motor = {2.0, 50.0};
        if (i == 20) world.setFreedom(hinge, 0, driven);
        world.step(1.0 / 60);
    }
    return world;
}

TEST(KeepingOfAWorld, HasSleepRemovedBodiesAndMotors) {
    World whole = eventful(100), rest = eventful(12);
    EXPECT_GT(whole.report().asleep, 0);
    ASSERT_TRUE(rest.restoreState(stateOf(whole)));
    for (World* world : {&whole, &rest}) {
        world->applyImpulse({1}, {3, 0, 0}, {0, 0.9, 0});
        support::run(*world, 60);
    }
    EXPECT_EQ(rest.hash(), whole.hash());
    EXPECT_EQ(rest.report().asleep, whole.report().asleep);
}

/// A bob that swings about x, and a motor on its twist about z, whose weight changes with the swing.
World twisted() {
    World world;
    const BodyId hook = world.add(support::hook({0, 6, 0}));
    const BodyId bob = world.add(support::body(Shape::box({0.2, 0.4, 0.3}), {0, 6, 1}));
    JointDef def = support::jointAt(world, JointType::ball, hook, bob, {0, 6, 0}, {0, 0, 1});
    def.free[0].motor = {3.0, 0.01};
    world.add(def);
    return world;
}

TEST(KeepingOfAWorld, HasMotorsOfAngles) {
    World whole = twisted(), rest = twisted();
    support::run(whole, 25);
    ASSERT_TRUE(rest.restoreState(stateOf(whole)));
    support::run(whole, 1), support::run(rest, 1);
    EXPECT_EQ(rest.hash(), whole.hash());
}

/// Joints that are swept, and a heavy box on a light one.
World swept() {
    Settings settings;
    settings.joints = JointSolving::rows;
    World world(settings);
    world.add(support::floorPlane());
    world.add(support::body(Shape::box({1, 1, 1}), {9, 0.5, 0}, 1.0));
    world.add(support::body(Shape::box({1, 1, 1}), {9, 1.5, 0}, 400.0));
    BodyId last = world.add(support::hook({0, 6, 0}));
    for (int i = 0; i < 4; ++i) {
        const BodyId next = world.add(support::body(Shape::sphere(0.1), {0.5 * i + 0.5, 6, 0}));
        support::join(world, JointType::ball, last, next, {0.5 * i + 0.25, 6, 0});
        last = next;
    }
    return world;
}

TEST(KeepingOfAWorld, HasSweptJointsAndSubstepsThatAreStillMoreThanNeeded) {
    World whole = swept(), rest = swept();
    support::run(whole, 30);
    whole.remove(BodyId{2});
    support::run(whole, 5);
    EXPECT_GT(whole.report().substeps, whole.settings().substeps);
    ASSERT_TRUE(rest.restoreState(stateOf(whole)));
    support::run(whole, 20), support::run(rest, 20);
    EXPECT_EQ(rest.report().substeps, whole.report().substeps);
    EXPECT_EQ(rest.hash(), whole.hash());
}

TEST(KeepingOfAWorld, RefusesBytesOfAnotherWorldAndTornOnes) {
    World world = support::stack(4);
    support::run(world, 30);
    const Bytes bytes = stateOf(world);
    EXPECT_FALSE(support::stack(5).restoreState(bytes));
    EXPECT_FALSE(support::stack(4).restoreState({}));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 40)
        EXPECT_FALSE(support::stack(4).restoreState(std::span(bytes).first(size))) << size;
    Bytes longer = bytes;
    longer.push_back(0);
    EXPECT_FALSE(support::stack(4).restoreState(longer));
}

TEST(KeepingOfAWorld, GoesOnFromVelocitiesThatNoStepAllows) {
    World world = support::stack(2), other = support::stack(2);
    support::run(world, 10);
    world.setVelocity({2}, {0, -1e36, 0}, {0, 0, 0});  // farther than any layer of contacts
    ASSERT_TRUE(other.restoreState(stateOf(world)));
    world.step(1.0 / 60), other.step(1.0 / 60);
    EXPECT_FALSE(world.report().incidents.empty());
    EXPECT_EQ(other.hash(), world.hash());
}

// A seal tells that bytes are damaged; if someone seals damaged bytes, the world may go on anyhow,
// but not crash.
TEST(KeepingOfAWorld, SurvivesAnyChangedByte) {
    World world = support::stack(3);
    support::run(world, 30);
    const Bytes bytes = stateOf(world);
    int taken = 0;
    for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 700) {
        Bytes changed = bytes;
        changed[at] ^= static_cast<std::uint8_t>(1u << (at % 8));
        World other = support::stack(3);
        if (!other.restoreState(changed)) continue;
        other.step(1.0 / 60);
        ++taken;
    }
    EXPECT_GT(taken, 0);
}

}  // namespace
}  // namespace engine
