// Motors and springs along joints' coordinates.
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

// alpha = M / (I + m l^2) until the speed is reached, whether or not the hinge is at the centre.
TEST(HingeMotor, ReachesItsSpeedAtItsTorqueByTheInertia) {
    for (const double arm : {0.0, 1.0}) {
        World world = support::weightless();
        const BodyId hook = world.add(support::hook());
        const BodyId wheel = world.add(ballOf(2, 0.01, {arm, 0, 0}));
        JointDef def = jointAt(world, JointType::hinge, hook, wheel, Vec3::Zero());
        def.free[0].motor = {3.0, 0.5 * (0.01 + 2 * arm * arm)};  // 0.5 rad/s^2
        const JointId id = world.add(def);
        run(world, 180);
        EXPECT_NEAR(world.joint(id).speed, 1.5, 1e-4);
        EXPECT_NEAR(world.joint(id).torque.z(), def.free[0].motor.strength, 1e-3);
        run(world, 240);
        EXPECT_NEAR(world.joint(id).speed, 3.0, 1e-6);
        EXPECT_LT(world.joint(id).separation, 1e-5);
    }
}

TEST(HingeMotor, OfSpeedZeroIsABrake) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), wheel = world.add(ballOf(1, 0.2, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::hinge, hook, wheel, Vec3::Zero());
    def.free[0].motor.strength = 0.1;
    const JointId id = world.add(def);
    world.setVelocity(wheel, Vec3::Zero(), {0, 0, 1});
    run(world, 60);
    EXPECT_NEAR(world.joint(id).speed, 0.5, 1e-9);  // 1 - M t / I
    run(world, 120);
    EXPECT_NEAR(world.joint(id).speed, 0.0, 1e-12);
    EXPECT_NEAR(world.joint(id).position, 1.0, 0.01);  // w^2 I / 2 M
}

/// The position of a lift of 2 kg after 2 s, with a motor of this strength.
JointState lift(double strength, const Settings& settings = Settings::steady()) {
    World world(settings);
    const BodyId hook = world.add(support::hook()), cabin = world.add(ballOf(2, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, hook, cabin, {0.3, 0, 0}, {0, 1, 0});
    def.free[0].motor = {0.5, strength};
    const JointId id = world.add(def);
    run(world, 120);
    return world.joint(id);
}

TEST(SliderMotor, LiftsWhatItIsStrongEnoughFor) {
    EXPECT_NEAR(lift(kUnlimited).position, 1.0, 1e-3);
    EXPECT_NEAR(lift(kUnlimited).force.y(), 2 * kGravity, 1e-3);
    EXPECT_NEAR(lift(2 * kGravity + 1).speed, 0.5, 1e-6);
    const JointState slips = lift(2 * kGravity - 1);
    EXPECT_NEAR(slips.speed, -0.5 * 2.0, 1e-6);  // (strength - m g) / m for 2 s
    EXPECT_NEAR(slips.force.y(), 2 * kGravity - 1, 1e-6);
}

TEST(SliderMotor, IsTheSameByEveryMethod) {
    for (const Method method : {Method::pgs, Method::pgsMatrix, Method::direct}) {
        Settings settings = Settings::steady();
        settings.method = method;
        settings.sweeps = 60;
        settings.tolerance = 1e-10;
        for (const double strength : {2 * kGravity - 1, 2 * kGravity + 1, kUnlimited}) {
            EXPECT_NEAR(lift(strength, settings).speed, lift(strength).speed, 1e-5);
            EXPECT_NEAR(lift(strength, settings).position, lift(strength).position, 1e-3);
        }
    }
}

TEST(SliderMotor, WorksInThePresetOfTheSeeds) {
    EXPECT_NEAR(lift(2 * kGravity + 1, Settings::seed()).speed, 0.5, 1e-2);
}

// A door closer: w = 2 pi hz about the hinge, for the whole inertia about it.
TEST(HingeSpring, SwingsAtItsFrequency) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook());
    const BodyId door = world.add(ballOf(5, 0.2, {0.8, 0, 0}));
    JointDef def = jointAt(world, JointType::hinge, hook, door, Vec3::Zero());
    def.free[0].spring = {2.0, 0.0};
    def.free[0].rest = 0.3;
    const JointId id = world.add(def);
    const double dt = 1.0 / 480;
    int crossings = 0;
    double first = 0.0, last = 0.0;
    while (crossings < 9) {
        const double before = world.joint(id).position - 0.3, t = world.report().time;
        world.step(dt);
        const double after = world.joint(id).position - 0.3;
        if ((before > 0) == (after > 0)) continue;
        last = t + dt * before / (before - after);
        if (crossings++ == 0) first = last;
    }
    EXPECT_NEAR((last - first) / 4, 0.5, 0.5 * 1e-3);
}

TEST(HingeSpring, HoldsEnergyThatCounts) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), arm = world.add(ballOf(2, 0.1, {1, 0, 0}));
    JointDef def = jointAt(world, JointType::hinge, hook, arm, Vec3::Zero());
    def.free[0].spring = {0.5, 0.0};
    world.add(def);
    world.setVelocity(arm, {0, 1, 0}, {0, 0, 1});
    const double whole = world.energy().total();
    EXPECT_NEAR(whole, 0.5 * (2 + 0.1), 1e-12);
    double elastic = 0.0;
    for (int i = 0; i < 60; ++i) {
        world.step(1.0 / 960);
        elastic = larger(elastic, world.energy().elastic);
        EXPECT_NEAR(world.energy().total(), whole, 0.01 * whole);
    }
    EXPECT_GT(elastic, 0.01);
}

/// Two bars joined at their ends, with springs on all that the joint leaves free, or a soft joint.
World sprungBars(JointType type, bool soft) {
    World world = support::weightless();
    BodyDef bar = support::body(Shape::box({1, 0.1, 0.1}), {0, 0, 0}, 2.0);
    bar.collide = false;
    const BodyId a = world.add(bar);
    bar.pose.position = {1, 0, 0}, bar.mass = 1.0;
    const BodyId b = world.add(bar);
    JointDef def = jointAt(world, type, a, b, {0.5, 0, 0}, {0, 0, 1}, {0, 1, 0});
    const Spring spring{1.0, 0.0};
    if (soft) def.spring = spring;
    if (soft) def.anchorB += Vec3(0.2, 0.3, 0), def.length = 0.5;
    const bool swings = type == JointType::ball, hinge = type == JointType::hinge;
    for (int i = swings ? 1 : type == JointType::sixDof ? 3 : 0; i < 6 && !soft; ++i) {
        if (i > 1 && type != JointType::sixDof) break;
        if (!(hinge && i > 0)) def.free[i].spring = spring;
    }
    for (int i = 0; type == JointType::sixDof && i < 3; ++i) def.free[i].locked = true;
    world.add(def);
    world.setVelocity(b, {0, 2, 0.7}, {0, 1, 4});
    run(world, 1);  // velocities fit the joint from now on
    return world;
}

// A stiffness that follows the masses, which change as the bars fold, would be pumped: up to 200,000 times.
TEST(JointSprings, KeepTheEnergyOfWideSwings) {
    using enum JointType;
    for (const auto& [type, soft] : {std::pair{hinge, false}, {universal, false}, {ball, false},
                                     {sixDof, false}, {ball, true}, {distance, true}}) {
        World world = sprungBars(type, soft);
        const double first = world.energy().total();
        for (int i = 0; i < 3600; ++i) {
            run(world, 1);
            ASSERT_NEAR(world.energy().total(), first, 0.01 * first)
                << static_cast<int>(type) << soft << ", step " << i;
        }
    }
}

/// A bar thrown on a soft joint, which folds it over: its angles are undefined there.
World thrownOnASoftJoint(JointType type, std::uint64_t seed) {
    support::Random random(seed);
    World world;
    const BodyId hook = world.add(support::hook());
    BodyDef bar = support::body(Shape::box({0.5, 0.1, 0.2}), {0.25, 0, 0}, 1.0);
    bar.collide = false;
    bar.velocity = random.vector(2), bar.spin = random.vector(3);
    const BodyId id = world.add(bar);
    const Vec3 axis = random.vector(1).normalized(), other = axis.cross(random.vector(1)).normalized();
    JointDef def = jointAt(world, type, hook, id, Vec3::Zero(), axis, other);
    const double stiffness = random.number(1, 100);  // N/m, N m/rad
    def.spring.stiffness = type == JointType::hinge ? 0.1 * stiffness : stiffness;
    if (type == JointType::hinge) def.free[0].spring.stiffness = 1000.0;
    if (type == JointType::sixDof) def.spring = {};
    for (int i = 0; i < 3 && type == JointType::sixDof; ++i) {
        def.free[i].locked = true;
        def.free[3 + i].spring.stiffness = stiffness * std::pow(10.0, i);
    }
    world.add(def);
    run(world, 6);
    return world;
}

// A spring on an angle alone gained up to millions of times the energy there.
TEST(JointSprings, OfSoftJointsThatFoldOverGainNoEnergy) {
    using enum JointType;
    for (const JointType type : {hinge, universal, constantVelocity, sixDof, wheel})
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            World world = thrownOnASoftJoint(type, seed);
            const double first = world.energy().total();
            const double scale = support::kGravity * 0.25 + world.energy().kinetic;
            double high = 0.0;
            for (int i = 0; i < 900; ++i) {
                run(world, 1);
                high = larger(high, (world.energy().total() - first) / scale);
            }
            EXPECT_LT(high, 0.05) << static_cast<int>(type) << ", seed " << seed;
        }
}

// Swung by nearly half a turn, a twist changes at 6000 rad/s, but not for as long as half a sub-step.
TEST(JointSprings, HoldNoMoreEnergyThanHalfATurnOfTwist) {
    World world = support::weightless();
    const BodyId wall = world.add(support::hook()), ball = world.add(ballOf(2, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::sixDof, wall, ball, Vec3::Zero());
    for (int i = 0; i < 3; ++i) def.free[i].locked = true;
    def.free[3].spring.stiffness = 100.0;  // N m/rad
    world.add(def);
    run(world, 1);
    const double half = 0.5 * 3.14;
    world.setPose(ball, {Vec3::Zero(), Quat(cosine(half), 0, 0, sine(half))});
    world.setVelocity(ball, Vec3::Zero(), {0, 5, 0});
    EXPECT_LT(world.energy().elastic, 0.5 * 100.0 * kPi * kPi);
}

void joinByMotors(World& world, JointType type, BodyId a, BodyId b, support::Random& random, double& power) {
    const Vec3 axis = random.vector(1).normalized(), at = 0.5 * (world.pose(a).position + world.pose(b).position);
    JointDef def = jointAt(world, type, a, b, at, axis);
    const bool six = type == JointType::sixDof;
    for (int i = 0; i < 3 && six; ++i) def.free[i].locked = true;
    for (int i = six ? 3 : 0; i < (six ? 6 : 2); ++i) {
        def.free[i].motor = {random.number(-10, 10), std::pow(10.0, random.number(-2, 2))};
        power += std::abs(def.free[i].motor.speed) * def.free[i].motor.strength;
    }
    world.add(def);
}

/// Four boxes that tumble through every angle of their joints, with motors on all of them; adds the power (W) of these.
World tumblingOnMotors(JointType type, const Settings& settings, std::uint64_t seed, double& power) {
    support::Random random(seed);
    World world = support::weightless(settings);
    BodyId last;
    for (int i = 0; i < 4; ++i) {
        BodyDef box = support::thrownBox(random, {0.6 * i, 0, 0});
        box.collide = false;
        const BodyId id = world.add(box);
        if (i > 0) joinByMotors(world, type, last, id, random, power);
        last = id;
    }
    return world;
}

// Swung by nearly half a turn, the twist's motor had the strength times thousands, and threw the bodies away.
TEST(Motor, HasItsStrengthWhereATwistIsUndefined) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const JointType type : {JointType::ball, JointType::sixDof})
            for (std::uint64_t seed = 1; seed <= 14; ++seed) {
                double power = 0.0;
                World world = tumblingOnMotors(type, settings, seed, power);
                run(world, 1);
                for (int i = 0; i < 200; ++i) {
                    const double before = world.energy().total();
                    run(world, 1);
                    ASSERT_LT(world.energy().total(), 1.02 * before + power * kStep)
                        << static_cast<int>(type) << ", seed " << seed << ", step " << i;
                }
            }
}

// The two rows contradict each other: neither impulse may grow without bound.
TEST(Motor, OfAnyStrengthStopsAtALimit) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), wheel = world.add(ballOf(2, 0.3, {0.5, 0, 0}));
    JointDef def = jointAt(world, JointType::hinge, hook, wheel, Vec3::Zero());
    def.free[0].motor = {1.0, kUnlimited};
    def.free[0].limits = {-0.1, 0.1};
    const JointId id = world.add(def);
    run(world, 600);
    EXPECT_NEAR(world.joint(id).position, 0.1, 1e-3);
    EXPECT_LT(world.velocity(wheel).norm(), 1e-3);
    EXPECT_LT(world.joint(id).torque.norm(), 1e-3);
}

TEST(Motor, KeepsAwakeWhatItTurns) {
    Settings settings = Settings::steady();
    settings.sleeping = true;
    World world = support::weightless(settings);
    const BodyId hook = world.add(support::hook()), table = world.add(ballOf(1, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::hinge, hook, table, Vec3::Zero());
    def.free[0].motor = {0.01, 1.0};
    const JointId id = world.add(def);
    run(world, 300);
    EXPECT_NEAR(world.joint(id).position, 0.05, 1e-6);
    world.setFreedom(id, 0, {});
    run(world, 120);
    EXPECT_TRUE(world.isAsleep(table));
    Freedom faster;
    faster.motor = {1.0, 1.0};
    world.setFreedom(id, 0, faster);
    run(world, 60);
    EXPECT_NEAR(world.joint(id).speed, 1.0, 1e-6);
}

}  // namespace
}  // namespace engine
