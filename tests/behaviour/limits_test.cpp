// Limits of joints' coordinates: where they stop, and the load they carry there.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/joints.h"

namespace engine {
namespace {

using support::ballOf;
using support::jointAt;
using support::kGravity;
using support::kStep;
using support::run;

// Full turns are counted: 5 rad/s for 2 s would be 573 degrees.
TEST(HingeLimit, StopsAt400Degrees) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), wheel = world.add(ballOf(2, 0.3, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::hinge, hook, wheel, Vec3::Zero());
    def.free[0].limits.high = radians(400);
    const JointId id = world.add(def);
    world.setVelocity(wheel, Vec3::Zero(), {0, 0, 5});
    double most = 0.0;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        most = larger(most, world.joint(id).position);
    }
    EXPECT_NEAR(world.joint(id).position, radians(400), 1e-6);
    EXPECT_LE(most, radians(400) + 1e-6);
    EXPECT_NEAR(world.joint(id).speed, 0.0, 1e-6);
}

TEST(HingeLimit, CountsTurnsBackwardsToo) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), wheel = world.add(ballOf(2, 0.3, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::hinge, hook, wheel, Vec3::Zero(), {0, 2, 0});
    const JointId id = world.add(def);
    world.setVelocity(wheel, Vec3::Zero(), {0, -7, 0});
    run(world, 600);
    EXPECT_NEAR(world.joint(id).position, -70.0, 1e-6);
    EXPECT_NEAR(world.joint(id).speed, -7.0, 1e-9);
}

// A small bob on a long arm: 400 times its own inertia about the hinge. At the limit the hinge carries
// the weight's moment m g l cos a.
class HingeLimitBy : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, HingeLimitBy,
                         testing::Values(Method::impulses, Method::pgs, Method::pgsMatrix,
                                         Method::direct),
                         [](const auto& one) { return std::to_string(static_cast<int>(one.param)); });

TEST_P(HingeLimitBy, HoldsAnArmAtItsAngle) {
    Settings settings = Settings::steady();
    settings.method = GetParam();
    if (GetParam() == Method::pgs || GetParam() == Method::pgsMatrix) settings.sweeps = 3000;
    World world(settings);
    const BodyId hook = world.add(support::hook());
    const BodyId bob = world.add(support::body(Shape::sphere(0.05), {1, 0, 0}, 3.0));
    JointDef def = jointAt(world, JointType::hinge, hook, bob, Vec3::Zero());
    def.free[0].limits = {radians(-30), radians(10)};
    const JointId id = world.add(def);
    run(world, 180);
    EXPECT_NEAR(world.joint(id).position, radians(-30), 1e-5);
    // Sequential impulses solve the point exactly, in a tree; the other methods leave it to one nudge per
    // step.
    const double apart = GetParam() == Method::impulses ? 1e-6 : 1e-3;  // m
    EXPECT_NEAR(world.pose(bob).position.y(), -0.5, 1e-4 + apart);
    EXPECT_LT(world.joint(id).separation, apart);
    // about b's anchor, which is the hinge itself
    EXPECT_NEAR(world.joint(id).torque.z(), 3.0 * kGravity * cosine(radians(30)), 0.02);
    EXPECT_NEAR(world.joint(id).force.y(), 3.0 * kGravity, 0.02);
}

// A limit changes nothing until it is reached.
TEST(HingeLimit, OutOfReachLeavesAPendulumAlone) {
    Vec3 at[2];
    for (const bool limited : {false, true}) {
        World world;
        const BodyId hook = world.add(support::hook());
        const BodyId bob = world.add(support::body(Shape::sphere(0.05), {1, 0, 0}, 3.0));
        JointDef def = jointAt(world, JointType::hinge, hook, bob, Vec3::Zero());
        if (limited) def.free[0].limits = {-4.0, 1.0};
        const JointId id = world.add(def);
        double low = 1e9, high = -1e9;
        for (int i = 0; i < 1200; ++i) {
            world.step(kStep);
            low = smaller(low, world.energy().total()), high = larger(high, world.energy().total());
        }
        EXPECT_LT(high - low, 0.015 * 3 * kGravity);
        EXPECT_LT(world.joint(id).separation, 1e-6);
        at[limited] = world.pose(bob).position;
    }
    EXPECT_LT((at[0] - at[1]).norm(), 1e-6);
}

// An arm of eight links held out by limits: each carries all links after it. They are solved with the arm.
TEST(HingeLimit, HoldsAChainStiff) {
    World world;
    BodyId last = world.add(support::hook());
    std::vector<JointId> joints;
    for (int i = 0; i < 8; ++i) {
        BodyDef link = support::body(Shape::box({0.5, 0.05, 0.05}), {0.5 * i + 0.25, 0, 0});
        link.collide = false;
        const BodyId next = world.add(link);
        JointDef def = jointAt(world, JointType::hinge, last, next, {0.5 * i, 0, 0});
        def.free[0].limits = {radians(-5), radians(5)};
        joints.push_back(world.add(def));
        last = next;
    }
    run(world, 600);
    EXPECT_LT(world.report().residual, 1e-9);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        EXPECT_NEAR(world.joint(joints[i]).position, radians(-5), radians(0.1)) << i;
        EXPECT_LT(world.joint(joints[i]).separation, 1e-3);
    }
    // links i to 7 hang on hinge i; the moment of the first is that of all links about the wall
    double moment = 0.0;
    for (int i = 1; i <= 8; ++i) moment += kGravity * world.pose({i}).position.x();
    EXPECT_NEAR(world.joint(joints[0]).torque.z(), moment, 0.02 * moment);
}

// A shoulder: an arm falls to the edge of its cone, whatever the direction of gravity.
TEST(BallLimit, HoldsAPendulumInItsCone) {
    for (const Vec3& pull : {Vec3(0, -9.81, 0), Vec3(0, 3, 6), Vec3(1, -4, 5)}) {
        World world;
        world.setGravity(pull);
        const BodyId hook = world.add(support::hook());
        const BodyId bob = world.add(support::body(Shape::sphere(0.05), {1, 0, 0}));
        JointDef def = jointAt(world, JointType::ball, hook, bob, Vec3::Zero(), Vec3::UnitX());
        def.free[1].limits.high = radians(20);
        def.free[0].limits = {-0.1, 0.1};
        const JointId id = world.add(def);
        double most = 0.0;
        for (int i = 0; i < 600; ++i) {
            world.step(kStep);
            most = larger(most, world.joint(id).positions[1]);
        }
        const Vec3 across = Vec3(0, pull.y(), pull.z()).normalized();
        EXPECT_NEAR(world.joint(id).positions[1], radians(20), 1e-4);
        EXPECT_LE(most, radians(20) + 1e-3);
        const double outward = pull.x() > 0 ? 1e-2 : 1e-3;
        EXPECT_NEAR(world.pose(bob).position.dot(across), sine(radians(20)), outward);
        EXPECT_LT(world.joint(id).separation, 1e-6);
    }
}

TEST(BallLimit, StopsItsTwist) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), bob = world.add(ballOf(1, 0.1, {0, 1, 0}));
    JointDef def = jointAt(world, JointType::ball, hook, bob, Vec3::Zero(), Vec3::UnitY());
    def.free[0].limits = {radians(-45), radians(90)};
    const JointId id = world.add(def);
    world.setVelocity(bob, Vec3::Zero(), {0, 3, 0});
    run(world, 60);
    EXPECT_NEAR(world.joint(id).position, radians(90), 1e-6);
    world.setVelocity(bob, Vec3::Zero(), {0, -3, 0});
    run(world, 120);
    EXPECT_NEAR(world.joint(id).position, radians(-45), 1e-6);
}

// A slack rope carries nothing and the ball falls freely; a taut rope carries its weight.
TEST(Rope, GoesSlackAndTaut) {
    World world;
    const BodyId hook = world.add(support::hook());
    const BodyId bob = world.add(support::body(Shape::sphere(0.05), {0, -0.2, 0}, 2.0));
    JointDef def;
    def.type = JointType::distance;
    def.a = hook, def.b = bob;
    def.free[0].limits = {0.0, 1.0};
    const JointId id = world.add(def);
    run(world, 20);
    const double h = kStep / world.report().substeps;
    const double n = 20 * world.report().substeps;
    EXPECT_NEAR(world.pose(bob).position.y(), -0.2 - 0.5 * kGravity * h * h * n * (n + 1), 1e-12);
    EXPECT_EQ(world.joint(id).force.norm(), 0.0);
    EXPECT_EQ(world.joint(id).separation, 0.0);
    run(world, 100);
    EXPECT_NEAR(world.joint(id).position, 1.0, 1e-6);
    EXPECT_NEAR(world.joint(id).force.y(), 2.0 * kGravity, 1e-6);
    world.setVelocity(bob, {0, 2, 0}, Vec3::Zero());
    run(world, 6);
    EXPECT_EQ(world.joint(id).force.norm(), 0.0);
}

// Sag of a spring of w = 2 pi hz is g / w^2; the stop below is either reached or not.
TEST(SoftDistance, SagsToItsStop) {
    for (const double stop : {2.0, 1.05}) {
        World world;
        const BodyId hook = world.add(support::hook());
        const BodyId bob = world.add(support::body(Shape::sphere(0.05), {0, -1, 0}, 2.0));
        JointDef def;
        def.type = JointType::distance;
        def.a = hook, def.b = bob;
        def.length = 1.0;
        def.spring = {1.0, 0.7};
        def.free[0].limits.high = stop;
        const JointId id = world.add(def);
        run(world, 600);
        const double sag = kGravity / (4 * kPi * kPi);
        EXPECT_NEAR(world.joint(id).position, smaller(1.0 + sag, stop), 1e-5);
        EXPECT_NEAR(world.joint(id).force.y(), 2.0 * kGravity, 1e-4);
    }
}

/// Boxes of 10 g to 100 kg on ball joints with narrow limits, thrown: in free space, or onto a floor.
World thrownLimbs(const Settings& settings, int links, bool floor, std::uint64_t seed) {
    support::Random random(seed);
    World world(settings);
    if (floor)
        world.add(support::floorPlane());
    else
        world.setGravity(Vec3::Zero());
    BodyId last;
    for (int i = 0; i < links; ++i) {
        BodyDef box = support::thrownBox(random, {0.6 * i, 2, 0});
        box.collide = floor;
        const BodyId id = world.add(box);
        if (i > 0) {
            JointDef def = jointAt(world, JointType::ball, last, id, {0.6 * i - 0.3, 2, 0}, random.vector(1).normalized());
            def.free[0].limits = {-random.number(0.1, 1.5), random.number(0.1, 1.5)};
            def.free[1].limits = {0.0, random.number(0.1, 1.5)};
            world.add(def);
        }
        last = id;
    }
    run(world, 1);
    return world;
}

/// The largest gain of energy in a step, as a share of it and 1 J.
double largestGain(World& world, int steps) {
    double most = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double before = world.energy().total();
        run(world, 1);
        most = larger(most, (world.energy().total() - before) / (before + 1.0));
    }
    return most;
}

// Swept over bodies, the limits of light limbs behind heavy ones did not converge, and those kept from the last
// sub-step added up to 2 % in a step.
TEST(BallLimits, OfLightLimbsOnHeavyOnesAddNoEnergy) {
    Settings inRows = Settings::steady();
    inRows.lanes = false;
    for (const auto& [settings, most] :
         {std::pair{Settings::steady(), 0.01}, {inRows, 0.01}, {Settings::fast(), 0.02}})
        for (const bool floor : {false, true})
            for (std::uint64_t seed = 1; seed <= 8; ++seed) {
                World world = thrownLimbs(settings, 4, floor, seed);
                EXPECT_LT(largestGain(world, 300), most) << floor << ", seed " << seed;
            }
}

// More rows act than are solved with a tree.
TEST(BallLimits, OfManyLimbsAddNoEnergy) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        World world = thrownLimbs(Settings::steady(), 30, false, seed);
        EXPECT_LT(largestGain(world, 60), 0.01) << "seed " << seed;
        EXPECT_LT(world.errors().separation, 0.01);
    }
}

TEST(SliderLimit, StopsAtBothEnds) {
    World world;
    const BodyId hook = world.add(support::hook()), block = world.add(ballOf(1, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, hook, block, Vec3::Zero(), {0, 1, 0});
    def.free[0].limits = {-0.5, 0.25};
    const JointId id = world.add(def);
    run(world, 60);
    EXPECT_NEAR(world.joint(id).position, -0.5, 1e-6);
    world.setGravity({0, 9.81, 0});
    run(world, 60);
    EXPECT_NEAR(world.joint(id).position, 0.25, 1e-6);
}

// Two equal bounds hold like a row of the joint.
TEST(SliderLimit, OfTwoEqualBoundsHoldsItThere) {
    World world;
    const BodyId hook = world.add(support::hook()), block = world.add(ballOf(1, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, hook, block, Vec3::Zero(), {0, 1, 0});
    def.free[0].limits = {0.1, 0.1};
    const JointId id = world.add(def);
    run(world, 120);
    EXPECT_NEAR(world.joint(id).position, 0.1, 1e-5);
    EXPECT_NEAR(world.joint(id).force.y(), kGravity, 1e-6);
}

}  // namespace
}  // namespace engine
