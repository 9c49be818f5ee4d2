// Sleeping bodies wake when anything could move them (engine/world_sleep.h).
#include <gtest/gtest.h>

#include "tests/support/sleepers.h"

namespace engine {
namespace {

using namespace support;

// A hit has the same effect as on a stack that never slept.
TEST(Waking, ABallThatHitsAStackWakesItInTime) {
    World world = sleepingStack(5), awake = support::stack(5);
    run(awake, 180);
    for (World* w : {&world, &awake}) {
        BodyDef ball = body(Shape::sphere(0.4), {-6, 2.5, 0}, kMass);
        ball.velocity = {20, 1, 0};
        w->add(ball);
    }
    double worst = 0.0;
    int slept = 0;
    for (int i = 0; i < 40; ++i) {
        world.step(kStep), awake.step(kStep);
        worst = std::max(worst, world.errors().penetration);
        if (sleepers(world) == 0) continue;
        EXPECT_EQ(world.errors().contacts, awake.errors().contacts);  // of the next step
        ++slept;
    }
    EXPECT_GT(slept, 10);  // on the ball's way
    EXPECT_LT(slept, 20);
    EXPECT_LT(worst, 0.02);
    for (int i = 1; i <= 6; ++i)
        EXPECT_LT((world.pose({i}).position - awake.pose({i}).position).norm(), 0.02) << i;
    EXPECT_GT(world.pose({3}).position.x(), 0.5);
    run(world, 600);
    for (const int i : {1, 2, 4, 5}) EXPECT_TRUE(world.isAsleep({i})) << i;
    EXPECT_FALSE(world.isAsleep({3}));  // the ball rolls along it and beyond
}

// Thrown against its neighbour within the step of the hit.
TEST(Waking, WhoIsThrownWakesWhomItWillHit) {
    World world(sleepy()), awake;
    double worst[2] = {};
    for (World* w : {&world, &awake}) {
        w->add(support::floorPlane());
        for (int i = 0; i < 3; ++i) w->add(body(kCube, {1.1 * i, 0.5, 0}, kMass));
        run(*w, 120);
        BodyDef ball = body(Shape::sphere(0.5), {-9, 0.6, 0}, 4 * kMass);
        ball.velocity = {20, 0, 0};
        w->add(ball);
        for (int i = 0; i < 60; ++i) {
            w->step(kStep);
            double& most = worst[w == &world ? 0 : 1];
            most = std::max(most, w->errors().penetration);
        }
        EXPECT_GT(w->velocity({3}).x(), 1.0);  // the third box
    }
    EXPECT_NEAR(worst[0], worst[1], 1e-3);  // woken only when it is touched: 98 mm
}

TEST(Waking, WithoutTheLowestBoxThoseAboveFall) {
    World world = sleepingStack(4);
    world.remove(BodyId{1});
    EXPECT_EQ(sleepers(world), 0);
    world.findContacts();
    EXPECT_EQ(world.errors().contacts, 8);
    run(world, 120);
    for (int i = 2; i <= 4; ++i) EXPECT_NEAR(height(world, {i}), i - 1.5, 5e-3);
    EXPECT_EQ(sleepers(world), 3);
}

TEST(Waking, WithoutTheFloorAllFall) {
    World world = sleepingStack(2);
    world.remove(BodyId{0});
    run(world, 60);
    EXPECT_LT(height(world, {1}), -4.0);
}

TEST(Waking, AFloorThatIsMovedAwayWakesThoseOnIt) {
    World world(sleepy());
    const BodyId table = world.add(support::fixed(Shape::box({4, 1, 4}), {0, -0.5, 0}));
    const BodyId box = world.add(body(kCube, {0, 0.5, 0}));
    run(world, 60);
    EXPECT_TRUE(world.isAsleep(box));
    world.setPose(table, {{0, -5.5, 0}, Quat::Identity()});
    run(world, 180);
    EXPECT_NEAR(height(world, box), -4.5, 5e-3);
    EXPECT_TRUE(world.isAsleep(box));
}

TEST(Waking, WhatIsPutIntoAnIslandWakesIt) {
    for (const BodyKind kind : {BodyKind::fixed, BodyKind::kinematic, BodyKind::dynamic}) {
        World world = sleepingStack(1);
        BodyDef def = body(kCube, {0.9, 0.5, 0}, kMass);  // 10 cm into the box
        def.kind = kind;
        const BodyId added = world.add(def);
        run(world, 30);
        EXPECT_LT(world.pose({1}).position.x(), -0.04);
        world.setPose(added, {{9, 0.5, 0}, Quat::Identity()});
        run(world, 120);
        EXPECT_TRUE(world.isAsleep({1}));
        const double before = world.pose({1}).position.x();
        world.setPose(added, {{before - 0.95, 0.5, 0}, Quat::Identity()});
        run(world, 30);
        EXPECT_GT(world.pose({1}).position.x(), before + 0.02);
    }
}

TEST(Waking, EveryCallThatCouldMoveItWakesIt) {
    const auto wakes = [](const char* what, auto call) {
        World world = sleepingStack(3);
        call(world);
        EXPECT_EQ(sleepers(world), 0) << what;
        run(world, 10);
        EXPECT_EQ(sleepers(world), 0) << what;
    };
    const BodyId top{3};
    wakes("force", [&](World& w) { w.applyForce(top, {1, 0, 0}); });
    wakes("impulse", [&](World& w) { w.applyImpulse(top, {1, 0, 0}, w.pose(top).position); });
    wakes("velocity", [&](World& w) { w.setVelocity(top, {0.1, 0, 0}, Vec3::Zero()); });
    wakes("pose", [&](World& w) { w.setPose(top, {{0.1, 2.5, 0}, Quat::Identity()}); });
    wakes("gravity", [&](World& w) { w.setGravity({0, -1.62, 0}); });
    wakes("settings", [&](World& w) { w.setSettings(Settings::steady()); });
    wakes("field", [&](World& w) { w.setForceField([](const World&, std::span<Load>) {}); });
    wakes("removal", [&](World& w) { w.remove(top); });
    World world = sleepingStack(3);
    world.setGravity(world.gravity());
    EXPECT_EQ(sleepers(world), 3);
}

TEST(Waking, MoreGravityPressesMore) {
    World world = sleepingStack(2);
    world.setGravity({0, -20, 0});
    run(world, 30);
    EXPECT_NEAR(loadOf(world), 2 * kMass * 20, 0.01 * 2 * kMass * 20);
}

TEST(Waking, AJointToABodyAwakeWakes) {
    World world = sleepingStack(2);
    BodyDef def = body(kCube, {3, 5, 0}, kMass);
    def.velocity = {5, 0, 0};
    const BodyId flying = world.add(def);
    run(world, 1);
    EXPECT_EQ(sleepers(world), 2);
    support::rod(world, {2}, flying);
    EXPECT_EQ(sleepers(world), 0);
    run(world, 60);
    EXPECT_GT(world.pose({2}).position.x(), 0.1);
}

// Bodies may sleep on a lift at rest, but not on a moving one, however slow.
TEST(Waking, AMovingKinematicBodyKeepsAwakeAndWakes) {
    World world(sleepy());
    BodyDef def = body(Shape::box({4, 1, 4}), {0, -0.5, 0});
    def.kind = BodyKind::kinematic;
    const BodyId lift = world.add(def);
    const BodyId box = world.add(body(kCube, {0, 0.5, 0}));
    const BodyId upper = world.add(body(kCube, {0, 1.5, 0}));
    world.setVelocity(lift, {0, 0.005, 0}, Vec3::Zero());
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        ASSERT_FALSE(world.isAsleep(box) || world.isAsleep(upper));
    }
    world.setVelocity(lift, Vec3::Zero(), Vec3::Zero());
    run(world, 60);
    EXPECT_TRUE(world.isAsleep(box) && world.isAsleep(upper));
    const double before = height(world, upper);
    world.setVelocity(lift, {0, 0.5, 0}, Vec3::Zero());
    EXPECT_FALSE(world.isAsleep(box));
    run(world, 60);
    EXPECT_NEAR(height(world, upper), before + 0.5, 2e-3);
}

TEST(Waking, AKinematicBodyThatComesByPushes) {
    World world = sleepingStack(2);
    BodyDef def = body(kCube, {-4, 0.6, 0});
    def.kind = BodyKind::kinematic;
    def.velocity = {2, 0, 0};
    const BodyId ram = world.add(def);
    run(world, 60);
    EXPECT_EQ(sleepers(world), 2);  // 1 m left
    run(world, 60);
    EXPECT_NEAR(world.pose({1}).position.x(), world.pose(ram).position.x() + 1.0, 0.01);
}

// Of a body that rolls over a cube, and is then replaced by a fixed plank under the cube.
TEST(ReusedNumber, BringsNoMotionOfTheRemovedBody) {
    World world(sleepy());
    world.add(support::floorPlane());
    BodyDef ball = body(Shape::box({0.8, 0.5, 0.5}), {-0.7, 1.3, 0}, kMass);
    ball.velocity = {3, 0, 0}, ball.spin = {0, 0, -9};
    const BodyId removed = world.add(ball), cube = world.add(body(kCube, {0, 0.5, 0}, kMass));
    run(world, 20);
    ASSERT_GT(world.velocity(removed).norm(), 0.5);
    world.remove(removed);
    run(world, 2);
    BodyDef plank = body(Shape::box({4, 0.2, 4}), {0, 2.1, 0});
    plank.kind = BodyKind::fixed;
    const BodyId below = world.add(plank);
    ASSERT_EQ(below.index, removed.index);
    world.setPose(cube, {{0.3, 2.7, 0}, Quat::Identity()});
    world.setVelocity(cube, Vec3::Zero(), Vec3::Zero());
    run(world, 60);
    EXPECT_NEAR(world.pose(cube).position.x(), 0.3, 1e-5);
    EXPECT_NEAR(world.pose(cube).position.y(), 2.7, 1e-3);
    EXPECT_NEAR(world.pose(cube).rotation.angularDistance(Quat::Identity()), 0.0, 1e-5);
}

// A floor of tiles that are put under a cube one after the other, while it sleeps.
TEST(Waking, ATileThatIsTakenAwayAndPutBackIsSeen) {
    World world(sleepy());
    BodyDef tile = body(Shape::box({2, 0.2, 2}), {0, -0.1, 0});
    tile.kind = BodyKind::fixed;
    const BodyId floor = world.add(tile), cube = world.add(body(kCube, {0, 0.5, 0}, kMass));
    run(world, 120);
    ASSERT_TRUE(world.isAsleep(cube));
    world.setPose(floor, {{0, -3.1, 0}, Quat::Identity()});
    run(world, 30);
    EXPECT_NEAR(height(world, cube), 0.5 - 0.5 * kGravity * 0.25, 0.1);
    run(world, 120);
    ASSERT_TRUE(world.isAsleep(cube));
    EXPECT_NEAR(height(world, cube), -2.5, 1e-3);
}

// Its potential energy goes with it at once, and the others keep theirs.
TEST(Sleeping, WhoIsRemovedAsleepTakesItsEnergyAlong) {
    World world = sleepingStack(1);
    const BodyId far = world.add(body(kCube, {5, 0.5, 0}, kMass));
    run(world, 180);
    ASSERT_EQ(sleepers(world), 2);
    run(world, 2);  // no body is active
    const double each = kMass * kGravity * 0.5;
    EXPECT_NEAR(world.energy().potential, 2 * each, 0.01 * each);
    world.remove(far);
    EXPECT_NEAR(world.energy().potential, each, 0.01 * each);
    run(world, 1);
    EXPECT_NEAR(world.energy().potential, each, 0.01 * each);
}

}  // namespace
}  // namespace engine
