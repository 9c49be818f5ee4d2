#include "engine/world.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kStep;
using support::run;

// mission 7: the second seed's six steps, in its order
TEST(World, StepsInTheSeedsOrder) {
    Settings settings = Settings::seed();
    World world = support::stack(1, settings);
    std::vector<Phase> phases;
    world.observe([&](Phase phase, int) { phases.push_back(phase); });
    world.step(kStep);
    EXPECT_EQ(phases, (std::vector{Phase::forces, Phase::velocities, Phase::impulses,
                                   Phase::positions, Phase::nudges, Phase::collisions}));
}

TEST(World, SubstepsRepeatTheFirstFiveAndDetectCollisionsOnce) {
    World world = support::stack(1);
    int impulses = 0, collisions = 0;
    world.observe([&](Phase phase, int) {
        impulses += phase == Phase::impulses;
        collisions += phase == Phase::collisions;
    });
    world.step(kStep);
    EXPECT_EQ(impulses, 4);
    EXPECT_EQ(collisions, 1);
}

// mission 7: contacts are also found before the first step, and after a body was moved
TEST(World, SeesContactsBeforeTheFirstStepAndAfterAMove) {
    World world = support::stack(1);
    world.findContacts();
    EXPECT_EQ(world.errors().contacts, 4);
    run(world, 10);
    world.setPose({1}, {{0, 5, 0}, Quat::Identity()});
    world.findContacts();
    EXPECT_EQ(world.errors().contacts, 0);
    world.setPose({1}, {{0, 0.499, 0}, Quat::Identity()});
    world.findContacts();
    EXPECT_EQ(world.contacts().size(), 4u);
    world.step(kStep);
    EXPECT_GT(world.contacts()[0].impulse, 0.0);
}

// mission 7: at its end, a step finds the contacts that the next one solves
TEST(World, SolvesInTheNextStepWhatItFoundInThis) {
    World world(Settings::seed());
    world.add(support::floorPlane());
    const BodyId ball = world.add(body(Shape::sphere(0.5), {0, 0.9, 0}));
    while (world.errors().contacts == 0) world.step(kStep);
    EXPECT_TRUE(world.contacts().empty());  // found, not solved
    EXPECT_GT(world.pose(ball).position.y(), 0.5);
    world.step(kStep);
    EXPECT_EQ(world.contacts().size(), 1u);
}

// mission 8: collision constraints are temporary, and so are the impulses of lost contacts
TEST(World, ForgetsTheContactsOfABodyThatHasLeft) {
    World world = support::stack(1, Settings::seed());
    run(world, 60);
    EXPECT_GT(world.contacts()[0].impulse, 1.0);
    world.setPose({1}, {{0, 5, 0}, Quat::Identity()});
    world.step(kStep);
    EXPECT_TRUE(world.contacts().empty());
    world.setPose({1}, {{0, 0.5, 0}, Quat::Identity()});
    world.setVelocity({1}, Vec3::Zero(), Vec3::Zero());
    world.findContacts();
    for (const ContactState& c : world.contacts()) EXPECT_EQ(c.impulse, 0.0);
}

// mission 4 and 5: box 1 x 2 x 4 m, 12 kg, turned 90 deg about z; impulse (0, 0, 1) at r = (0, 1, 0)
TEST(World, AnImpulseOffCentreTurnsABoxByItsWorldInertia) {
    World world;
    BodyDef box = body(Shape::box({1, 2, 4}), {3, 2, 1}, 12.0);
    box.pose.rotation = Quat(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
    const BodyId id = world.add(box);
    world.applyImpulse(id, {0, 0, 1}, {3, 3, 1});
    EXPECT_LT((world.spin(id) - Vec3(1.0 / 17.0, 0, 0)).norm(), 1e-15);
    EXPECT_LT((world.velocity(id) - Vec3(0, 0, 1.0 / 12.0)).norm(), 1e-15);
}

// mission 29: the residual of every sweep is in the report
TEST(World, ReportsEverySweep) {
    World world = support::stack(5, Settings::seed());
    world.step(kStep);
    ASSERT_EQ(world.report().sweeps.size(), 10u);
    for (int i = 1; i < 10; ++i)
        EXPECT_LT(world.report().sweeps[i].delta, world.report().sweeps[i - 1].delta) << i;
    EXPECT_EQ(world.report().residual, world.report().sweeps.back().residual);
}

// mission 9: a static body's pose is the same to the bit after 10^4 steps
TEST(World, AFixedBodyNeverMoves) {
    World world;
    BodyDef table = support::fixed(Shape::box({3, 1, 3}), {0.1, 0.2, 0.3});
    table.pose.rotation = Quat(0.99, 0.01, 0.02, 0.03).normalized();
    const BodyId id = world.add(table);
    const Pose before = world.pose(id);
    world.add(body(Shape::box({1, 1, 1}), {0, 2, 0}, 50));
    world.applyImpulse(id, {1e6, 0, 0}, {0, 1, 0});
    world.applyForce(id, {1e6, 0, 0});
    run(world, 10000);
    EXPECT_EQ(world.pose(id).position, before.position);
    EXPECT_EQ(world.pose(id).rotation.coeffs(), before.rotation.coeffs());
}

TEST(World, AKinematicBodyMovesAsToldAndCarries) {
    World world;
    BodyDef belt = support::fixed(Shape::box({20, 1, 4}), {0, -0.5, 0});
    belt.kind = BodyKind::kinematic;
    belt.velocity = {1, 0, 0};
    const BodyId moving = world.add(belt);
    const BodyId box = world.add(body(Shape::box({1, 1, 1}), {0, 0.5, 0}, 5));
    run(world, 120);
    EXPECT_NEAR(world.pose(moving).position.x(), 2.0, 1e-9);
    EXPECT_NEAR(world.velocity(box).x(), 1.0, 1e-3);  // friction has accelerated it to the belt's speed
}

TEST(World, KinematicSpinTurnsAsTold) {
    World world;
    BodyDef wheel = support::fixed(Shape::sphere(1));
    wheel.kind = BodyKind::kinematic;
    wheel.spin = {0, 0, 1.0};
    const BodyId id = world.add(wheel);
    run(world, 60);
    const Vec3 x = world.pose(id).rotation * Vec3(1, 0, 0);
    EXPECT_NEAR(std::atan2(x.y(), x.x()), 1.0, 1e-12);
}

// mission 24: a removed body leaves no cached impulses
TEST(World, ARemovedBodyLeavesNothingBehind) {
    World world = support::stack(3);
    run(world, 60);
    world.remove(BodyId{2});
    EXPECT_FALSE(world.has({2}));
    for (const ContactState& c : world.contacts()) EXPECT_TRUE(c.a.index != 2 && c.b.index != 2);
    run(world, 120);
    EXPECT_NEAR(world.pose({3}).position.y(), 1.5, 0.01);  // fell on the first
    for (const ContactState& c : world.contacts()) EXPECT_TRUE(c.a.index != 2 && c.b.index != 2);
}

TEST(World, ReadingChangesNothing) {
    World world = support::stack(5), looked = support::stack(5);
    for (int i = 0; i < 120; ++i) {
        const World& reader = looked;
        const std::size_t points = reader.contacts().size();
        EXPECT_EQ(reader.contacts().size(), points);
        reader.errors(), reader.report(), reader.energy();
        if (i == 60) world.setPose({3}, {{0.2, 2.6, 0}, Quat::Identity()});
        if (i == 60) looked.setPose({3}, {{0.2, 2.6, 0}, Quat::Identity()});
        reader.castRay({0, 9, 0}, {0, -1, 0}), reader.contacts();
        world.step(kStep), looked.step(kStep);
        ASSERT_EQ(world.hash(), looked.hash()) << i;
    }
}

TEST(World, DoesNotGrowWhileBodiesComeAndGo) {
    World world;
    world.add(support::floorPlane());
    const BodyId post = world.add(support::hook({0, 3, 0}));
    BodyId old;
    for (int i = 0; i < 1000; ++i) {
        const BodyId ball = world.add(body(Shape::sphere(0.1), {0.5, 2, 0}));
        const JointId rod = support::rod(world, post, ball);
        const ForceId wind = world.add(ForceDef{Drag{.linear = 0.1}, {ball}});
        world.step(kStep);
        world.remove(wind);
        if (i % 2 == 0) world.remove(rod);
        world.remove(ball);
        EXPECT_FALSE(world.has(ball));
        EXPECT_NE(old, ball);
        EXPECT_FALSE(world.has(old));
        old = ball;
    }
    EXPECT_LE(world.bodyCount(), 6);
    EXPECT_LE(world.jointCount(), 4);
}

TEST(World, AnIdNamesOneBodyForEver) {
    World world;
    world.watchTouches(true);
    world.add(support::floorPlane());
    const BodyId first = world.add(body(Shape::box({1, 1, 1}), {0, 0.5, 0}));
    run(world, 2);
    world.remove(first);
    EXPECT_NEAR(world.pose(first).position.x(), 0.0,
                1e-6);  // the last pose, until the number is used again
    world.step(kStep);
    ASSERT_EQ(world.touches().size(), 1u);
    EXPECT_EQ(world.touches()[0].b, first);
    const BodyId second = world.add(body(Shape::box({1, 1, 1}), {3, 0.5, 0}));
    EXPECT_EQ(second.index, first.index);
    EXPECT_FALSE(world.has(first));
    EXPECT_TRUE(world.has(second));
    world.step(kStep);
    ASSERT_EQ(world.contacts().size(), 4u);
    EXPECT_EQ(world.contacts()[0].b, second);
    EXPECT_DEATH(world.pose(first), "no such body");
    EXPECT_DEATH(world.remove(first), "no such body");
}

TEST(World, AForceDoesNotPassToTheNextBodyOfANumber) {
    World world;
    world.setGravity(Vec3::Zero());
    const BodyId first = world.add(body(Shape::sphere(0.1), {0, 0, 0}));
    const BodyId other = world.add(body(Shape::sphere(0.1), {5, 0, 0}));
    world.add(ForceDef{ConstantForce{.force = {0, 9, 0}}, {first}});
    world.add(ForceDef{SpringForce{.stiffness = 10.0}, {first, other}});
    world.remove(first);
    world.step(kStep);
    const BodyId second = world.add(body(Shape::sphere(0.1), {0, 3, 0}));
    ASSERT_EQ(second.index, first.index);
    run(world, 10);
    EXPECT_EQ(world.velocity(second), Vec3(0, 0, 0));
    EXPECT_EQ(world.velocity(other), Vec3(0, 0, 0));
}

TEST(World, ABodyTakesItsJointsAlong) {
    World world;
    const BodyId a = world.add(support::hook()), b = world.add(body(Shape::sphere(0.1), {1, 0, 0}));
    const BodyId c = world.add(body(Shape::sphere(0.1), {2, 0, 0}));
    const JointId ab = support::rod(world, a, b), bc = support::rod(world, b, c);
    run(world, 10);
    world.remove(b);
    EXPECT_TRUE(world.joint(ab).removed && world.joint(bc).removed);
    const double speed = world.velocity(c).y();
    world.step(kStep);
    EXPECT_NEAR(world.velocity(c).y(), speed - support::kGravity * kStep, 1e-12);
}

TEST(World, JointedBodiesDoNotCollideAndOthersDo) {
    World world;
    const BodyId a = world.add(body(Shape::box({1, 1, 1}), {0, 0, 0}));
    const BodyId b = world.add(body(Shape::box({1, 1, 1}), {0.9, 0, 0}));
    const JointId joint = support::join(world, JointType::ball, a, b, {0.45, 0, 0});
    world.findContacts();
    EXPECT_EQ(world.contacts().size(), 0u);
    world.remove(joint);
    world.findContacts();
    EXPECT_EQ(world.contacts().size(), 4u);
}

TEST(World, ReportsTimeInCountsAndNotSums) {
    World world;
    world.add(body(Shape::sphere(0.5), {0, 5, 0}));
    run(world, 600);
    EXPECT_EQ(world.report().step, 600);
    EXPECT_EQ(world.report().time, 600 * kStep);
}

// mission 20: five 2 kg boxes at rest press the floor with 98.1 N
TEST(World, ReactionForcesCarryTheWeight) {
    World world = support::stack(5, Settings::steady(), 0.6, 2.0);
    run(world, 300);
    double floor = 0.0;
    for (const ContactState& c : world.contacts())
        if (c.a.index == 0) floor -= c.impulse * c.normal.y() / kStep;
    EXPECT_NEAR(std::abs(floor), 98.1, 0.05);
}

TEST(World, MayChangeItsSettingsBetweenTwoSteps) {
    World world = support::stack(5);
    run(world, 60);
    world.setSettings(Settings::seed());
    run(world, 60);
    world.setSettings(Settings::steady());
    run(world, 60);
    for (int i = 1; i <= 5; ++i) EXPECT_NEAR(world.pose({i}).position.y(), i - 0.5, 0.02);
}

TEST(World, StopsTheProgramAtTheCallersBugs) {
    World world;
    const BodyId id = world.add(body(Shape::sphere(1), Vec3::Zero()));
    EXPECT_DEATH(world.step(0.0), "a step needs a positive time");
    EXPECT_DEATH((void)world.pose({7}), "no such body");
    EXPECT_DEATH(support::join(world, JointType::ball, id, id, Vec3::Zero()), "two different");
    Settings both = Settings::steady();
    both.baumgarte = 0.2;
    EXPECT_DEATH(world.setSettings(both), "never both");
    BodyDef weightless = body(Shape::sphere(1), Vec3::Zero());
    weightless.mass = 0.0;
    EXPECT_DEATH(world.add(weightless), "positive mass");
}

}  // namespace
}  // namespace engine
