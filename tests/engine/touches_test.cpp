// Touch events of contacts and sensors, and groups that pass through each other.
#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::kGravity;
using Kind = TouchEvent::Kind;

/// All events of some steps.
std::vector<TouchEvent> eventsOf(World& world, int steps, double dt = support::kStep) {
    std::vector<TouchEvent> all;
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
        all.insert(all.end(), world.touches().begin(), world.touches().end());
    }
    return all;
}

/// A ball of 2 kg, its lowest point `height` above a floor; body 0 is the floor.
World dropped(double height, double restitution) {
    World world;
    BodyDef floor = support::floorPlane();
    floor.material.restitution = restitution;
    world.add(floor);
    world.add(support::body(Shape::sphere(0.5), {0, 0.5 + height, 0}, 2.0));
    world.watchTouches(true);
    return world;
}

// v = sqrt(2 g h), m v (1 + e) from begin to end
TEST(Touches, ABounceBeginsAndEndsWithItsImpulse) {
    World world = dropped(1.0, 0.5);
    const std::vector<TouchEvent> events = eventsOf(world, 45);
    ASSERT_EQ(events.size(), 2u);
    const double speed = std::sqrt(2 * kGravity);
    EXPECT_EQ(events[0].kind, Kind::begin);
    EXPECT_EQ(events[0].a.index, 0);
    EXPECT_EQ(events[0].b.index, 1);
    EXPECT_FALSE(events[0].sensor);
    EXPECT_NEAR(events[0].time, std::sqrt(2.0 / kGravity), 1.0 / 60);
    EXPECT_NEAR(events[0].time, static_cast<double>(events[0].step) / 60, 1e-12);
    EXPECT_NEAR(events[0].speed, speed, 2 * kGravity / 60);  // at the start of the step
    EXPECT_NEAR(events[0].position.y(), 0.0, speed / 60);
    EXPECT_EQ(events[0].normal, Vec3(0, 1, 0));
    EXPECT_EQ(events[1].kind, Kind::end);
    EXPECT_GT(events[1].step, events[0].step);
    EXPECT_NEAR(events[1].impulse, 2.0 * speed * 1.5, 0.35);  // plus its weight for a step or two
    EXPECT_GE(events[1].impulse, events[0].impulse);
}

TEST(Touches, WhatRestsBeginsOnceAndAddsUpItsWeight) {
    World world = dropped(0.0, 0.0);
    EXPECT_EQ(eventsOf(world, 120).size(), 1u);
    world.applyImpulse({1}, {0, 20, 0}, world.pose({1}).position);
    const std::vector<TouchEvent> events = eventsOf(world, 10);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, Kind::end);
    EXPECT_NEAR(events[0].impulse, 2.0 * kGravity * 2.0, 0.02 * 2.0 * kGravity * 2.0);  // m g t
}

TEST(Touches, AreReportedInTheOrderOfPairs) {
    World world(Settings::steady());
    world.add(support::floorPlane());
    for (const double x : {4.0, 0.0, 2.0})
        world.add(support::body(Shape::box({1, 1, 1}), {x, 0.5, 0}));
    world.watchTouches(true);
    const std::vector<TouchEvent> events = eventsOf(world, 1);
    ASSERT_EQ(events.size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(events[i].b.index, i + 1);
}

TEST(Touches, AreNotKeptUnlessAskedFor) {
    World world = dropped(0.0, 0.0);
    world.watchTouches(false);
    EXPECT_TRUE(eventsOf(world, 5).empty());
    world.watchTouches(true);
    EXPECT_EQ(eventsOf(world, 5).size(), 1u);
}

TEST(Touches, EndWhenABodyIsRemoved) {
    World world = dropped(0.0, 0.0);
    eventsOf(world, 5);
    world.remove(BodyId{1});
    const std::vector<TouchEvent> events = eventsOf(world, 2);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, Kind::end);
}

TEST(Touches, LastWhileTheTwoSleep) {
    World world = dropped(0.0, 0.0);
    Settings settings = Settings::steady();
    settings.sleeping = true;
    world.setSettings(settings);
    EXPECT_EQ(eventsOf(world, 120).size(), 1u);
    EXPECT_TRUE(world.isAsleep({1}));
}

TEST(Touches, ChangeNoBit) {
    World watched = support::stack(5), plain = support::stack(5);
    watched.watchTouches(true);
    support::run(watched, 60), support::run(plain, 60);
    EXPECT_EQ(watched.hash(), plain.hash());
}

/// A sensor 1 m thick whose middle is at height 3, over a floor.
BodyDef gate() {
    BodyDef def = support::fixed(Shape::box({4, 1, 4}), {0, 3, 0});
    def.sensor = true;
    return def;
}

// It enters when the lowest point is at 3.5, and leaves when the highest is at 2.5: 2 m later.
TEST(Sensors, TellOfWhatFallsThroughAndHoldNothingUp) {
    World world, without;
    for (World* w : {&world, &without}) {
        w->add(support::floorPlane());
        w->add(support::body(Shape::sphere(0.5), {0, 5, 0}));
    }
    const BodyId sensor = world.add(gate());
    world.watchTouches(true);
    const std::vector<TouchEvent> events = eventsOf(world, 50);
    support::run(without, 50);
    ASSERT_EQ(events.size(), 2u);
    const auto timeOfFall = [](double way) { return std::sqrt(2 * way / kGravity); };
    EXPECT_EQ(events[0].b, sensor);
    EXPECT_TRUE(events[0].sensor);
    EXPECT_NEAR(events[0].time, timeOfFall(1.0), 1.0 / 60);
    EXPECT_NEAR(events[0].speed, kGravity * timeOfFall(1.0), kGravity / 60);
    EXPECT_NEAR(events[1].time, timeOfFall(3.0), 1.0 / 60);
    EXPECT_EQ(events[0].impulse, 0.0);
    EXPECT_EQ(events[1].impulse, 0.0);
    EXPECT_EQ(world.pose({1}).position, without.pose({1}).position);
}

TEST(Sensors, KeepWhoSleepsInThem) {
    Settings settings = Settings::steady();
    settings.sleeping = true;
    World world = support::stack(1, settings);
    BodyDef def = gate();
    def.pose.position = {0, 0.5, 0};
    world.add(def);
    world.watchTouches(true);
    EXPECT_EQ(eventsOf(world, 120).size(), 2u);  // the floor, the sensor
    EXPECT_TRUE(world.isAsleep({1}));
}

TEST(Sensors, StopNoRay) {
    World world;
    world.add(gate());
    EXPECT_FALSE(world.castRay({0, 9, 0}, {0, -9, 0}).has_value());
}

// So fast that the pair gets its contact from the time of impact.
TEST(Sensors, ThrowNobodyThatIsShotThrough) {
    World world;
    world.setGravity(Vec3::Zero());
    world.add(gate());
    BodyDef bullet = support::body(Shape::sphere(0.1), {0, 9, 0});
    bullet.velocity = {0, -50, 0};
    const BodyId id = world.add(bullet);
    support::run(world, 30);
    EXPECT_EQ(world.velocity(id), Vec3(0, -50, 0));
}

// Groups 1 and 2: a body falls through another if either ignores a group of the other.
TEST(Groups, PassThroughWhomTheyIgnore) {
    for (const bool floorSays : {false, true}) {
        World world;
        BodyDef floor = support::floorPlane();
        BodyDef slab = support::fixed(Shape::box({9, 1, 9}), {0, 2, 0});
        BodyDef ghost = support::body(Shape::sphere(0.5), {0, 5, 0});
        BodyDef solid = support::body(Shape::sphere(0.5), {2, 5, 0});
        ghost.groups = 1u, slab.groups = floor.groups = 2u;
        (floorSays ? slab : ghost).ignores = floorSays ? 1u : 2u;
        if (!floorSays) floor.groups = 4u;
        world.add(floor), world.add(slab);
        const BodyId through = world.add(ghost), on = world.add(solid);
        support::run(world, 180);
        EXPECT_NEAR(world.pose(through).position.y(), 0.5, 0.01);
        EXPECT_NEAR(world.pose(on).position.y(), 3.0, 0.01);
    }
}

TEST(Groups, OfTheHighestBitCountAsWell) {
    World world;
    BodyDef floor = support::floorPlane(), ball = support::body(Shape::sphere(0.5), {0, 1, 0});
    floor.groups = ball.ignores = 1u << 31;
    world.add(floor);
    const BodyId id = world.add(ball);
    support::run(world, 60);
    EXPECT_LT(world.pose(id).position.y(), -3.0);
}

}  // namespace
}  // namespace engine
