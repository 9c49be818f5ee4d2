// Wheels on coil-overs.
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

constexpr double kHz = 1.5;
const double kSag = kGravity / (4 * kPi * kPi * kHz * kHz);  // m g / k, k = m (2 pi hz)^2

/// A wheel on a wall, its suspension upright, its axle along z.
struct Coilover {
    World world;
    BodyId wheel;
    JointId joint;

    explicit Coilover(double damping) {
        const BodyId wall = world.add(support::hook());
        wheel = world.add(ballOf(20, 0.4, {0, 0, 0}));
        JointDef def = jointAt(world, JointType::wheel, wall, wheel, Vec3::Zero(), Vec3::UnitY(),
                               Vec3::UnitZ());
        def.free[0].spring = {kHz, damping};
        joint = world.add(def);
    }
};

TEST(Wheel, SagsByItsWeightOverTheSpring) {
    Coilover c(0.7);
    run(c.world, 600);
    EXPECT_NEAR(c.world.joint(c.joint).position, -kSag, 1e-6);
    EXPECT_NEAR(c.world.joint(c.joint).force.y(), 20 * kGravity, 1e-4);
}

TEST(Wheel, SwingsAtTheFrequencyOfItsSpring) {
    Coilover c(0.0);
    const double dt = 1.0 / 480;
    int crossings = 0;
    double first = 0.0, last = 0.0;
    while (crossings < 9) {
        const double before = c.world.joint(c.joint).position + kSag, t = c.world.report().time;
        c.world.step(dt);
        const double after = c.world.joint(c.joint).position + kSag;
        if ((before > 0) == (after > 0)) continue;
        last = t + dt * before / (before - after);
        if (crossings++ == 0) first = last;
    }
    EXPECT_NEAR((last - first) / 4, 1 / kHz, 1e-3 / kHz);
}

TEST(Wheel, SpinsFreelyAndTurnsNowhereElse) {
    Coilover c(0.7);
    c.world.setVelocity(c.wheel, Vec3::Zero(), {1, 2, 30});
    run(c.world, 120);
    EXPECT_NEAR(c.world.joint(c.joint).speeds[1], 30.0, 1e-6);
    EXPECT_NEAR(c.world.joint(c.joint).positions[1], 60.0, 0.1);  // more than 9.5 turns
    EXPECT_LT(Vec3(c.world.spin(c.wheel) - Vec3(0, 0, 30)).norm(), 1e-6);
    EXPECT_LT(c.world.joint(c.joint).separation, 1e-6);
}

// A cart with four wheels: rests on its springs, drives at the speed of its rims, stops when
// braked.
TEST(Wheel, FourDriveACart) {
    World world;
    world.add(support::floorPlane());
    const BodyId deck = world.add(support::body(Shape::box({2, 0.2, 1}), {0, 0.6, 0}, 200.0));
    std::vector<JointId> wheels;
    for (const double x : {-0.8, 0.8})
        for (const double z : {-0.7, 0.7}) {
            BodyDef def = support::body(Shape::sphere(0.3), {x, 0.3, z}, 10.0);
            const BodyId wheel = world.add(def);
            JointDef joint = jointAt(world, JointType::wheel, deck, wheel, {x, 0.3, z},
                                     Vec3::UnitY(), Vec3::UnitZ());
            joint.free[0].spring = {4.0, 0.7};
            joint.free[0].limits = {-0.1, 0.15};
            joint.free[1].motor = {-5.0, 60.0};
            wheels.push_back(world.add(joint));
        }
    run(world, 600);
    EXPECT_NEAR(world.velocity(deck).x(), 1.5, 0.01);  // w r
    EXPECT_NEAR(world.velocity(deck).z(), 0.0, 1e-3);
    double carried = 0.0;
    for (const JointId id : wheels) {
        carried -= world.joint(id).force.y();
        EXPECT_GT(world.joint(id).position, 0.0);  // pressed up against the deck
        EXPECT_LT(world.joint(id).separation, 1e-3);
    }
    EXPECT_NEAR(carried, 200 * kGravity, 0.01 * 200 * kGravity);
    Freedom brake;
    brake.motor = {0.0, 200.0};
    for (const JointId id : wheels) world.setFreedom(id, 1, brake);
    run(world, 120);
    EXPECT_LT(world.velocity(deck).norm(), 0.01);
}

}  // namespace
}  // namespace engine
