// Joints that break under too much force or torque.
#include <gtest/gtest.h>

#include "tests/support/joints.h"

namespace engine {
namespace {

using support::jointAt;
using support::kGravity;
using support::kStep;
using support::run;

/// 2 kg on a joint to the wall at the origin; its centre is 0.5 m away.
struct Bracket {
    World world;
    BodyId beam;
    JointId joint;

    Bracket(JointType type, const Vec3& at, double force, double torque) {
        const BodyId wall = world.add(support::hook());
        beam = world.add(support::body(Shape::box({1, 0.1, 0.1}), at, 2.0));
        JointDef def = jointAt(world, type, wall, beam, Vec3::Zero());
        def.breakForce = force;
        def.breakTorque = torque;
        joint = world.add(def);
    }
};

TEST(BreakForce, HoldsTheWeightAndNotMuchMore) {
    Bracket it(JointType::ball, {0, -0.5, 0}, 1.5 * 2 * kGravity, kUnlimited);
    run(it.world, 60);
    EXPECT_FALSE(it.world.joint(it.joint).removed);
    EXPECT_TRUE(it.world.report().broken.empty());
    it.world.applyForce(it.beam, {0, -0.6 * 2 * kGravity, 0});
    it.world.step(kStep);
    ASSERT_EQ(it.world.report().broken.size(), 1u);
    EXPECT_EQ(it.world.report().broken[0], it.joint);
    EXPECT_TRUE(it.world.joint(it.joint).removed);
    EXPECT_TRUE(it.world.joint(it.joint).broken);
    EXPECT_NEAR(it.world.joint(it.joint).force.y(), 1.6 * 2 * kGravity, 1e-6);
    const double before = it.world.velocity(it.beam).y();
    it.world.step(kStep);
    EXPECT_NEAR(it.world.velocity(it.beam).y() - before, -kGravity * kStep, 1e-12);
    EXPECT_TRUE(it.world.report().broken.empty());
}

// A cantilever: m g l = 9.81 N m at the wall
TEST(BreakTorque, IsThatOfTheLever) {
    for (const bool breaks : {false, true}) {
        const double torque = 2 * kGravity * 0.5;
        Bracket it(JointType::weld, {0.5, 0, 0}, kUnlimited, breaks ? 0.99 * torque : 1.01 * torque);
        run(it.world, 120);
        EXPECT_EQ(it.world.joint(it.joint).broken, breaks);
    }
}

// Joined bodies do not collide; after the joint breaks they do.
TEST(BreakForce, WhatFallsAsleepBrokenWakesAndCollides) {
    Settings settings = Settings::steady();
    settings.sleeping = true;
    World world(settings);
    world.add(support::floorPlane());
    const BodyId shelf = world.add(support::fixed(Shape::box({1, 0.2, 1}), {0, 1, 0}));
    const BodyId box = world.add(support::body(Shape::box({0.4, 0.4, 0.4}), {0, 2, 0}, 1.0));
    JointDef def = jointAt(world, JointType::weld, shelf, box, {0, 1, 0});
    def.breakForce = 20.0;
    const JointId id = world.add(def);
    run(world, 120);
    EXPECT_TRUE(world.isAsleep(box));
    world.applyForce(box, {0, -15, 0});
    world.step(kStep);
    EXPECT_TRUE(world.joint(id).broken);
    run(world, 120);
    EXPECT_NEAR(world.pose(box).position.y(), 1.3, 0.01);  // on the shelf
}

}  // namespace
}  // namespace engine
