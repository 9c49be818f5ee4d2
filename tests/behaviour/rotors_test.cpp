// Inertia along a joint's coordinate: a weightless rotor that turns with it.
#include <gtest/gtest.h>

#include "tests/support/joints.h"

namespace engine {
namespace {

using support::ballOf;
using support::jointAt;
using support::kGravity;
using support::kStep;
using support::run;

/// Speed of 1 kg with a rotor of 3 kg on a vertical slider, after a second.
double speedOfTheLift(const Settings& settings) {
    World world(settings);
    const BodyId hook = world.add(support::hook()), weight = world.add(ballOf(1, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, hook, weight, Vec3::Zero(), {0, 1, 0});
    def.free[0].inertia = 3.0;
    const JointId id = world.add(def);
    run(world, 60);
    return world.joint(id).speed;
}

TEST(Rotor, SlowsAFallByItsShare) {
    for (const Method method : {Method::impulses, Method::pgs, Method::pgsMatrix, Method::direct}) {
        Settings settings;
        settings.method = method;
        EXPECT_NEAR(speedOfTheLift(settings), -kGravity / 4.0, 1e-3);  // m g = (m + I) a
    }
}

Settings substeps(int count) {
    Settings settings;
    settings.substeps = settings.maxSubsteps = count;
    return settings;
}

/// The energy lost in 5 s, J, by two rods in a chain whose joints both have a rotor.
double energyLost(double inertia, const Settings& settings) {
    World world(settings);
    BodyId before = world.add(support::hook());
    for (int i = 0; i < 2; ++i) {
        const BodyId rod = world.add(
            support::body(Shape::capsule(0.05, 1.0), {0.5 + i, 0, 0}, 1.0));
        world.setPose(rod, {{0.5 + i, 0, 0}, Quat(Eigen::AngleAxisd(-1.5707963267948966,
                                                                    Vec3::UnitZ()))});
        JointDef def = jointAt(world, JointType::hinge, before, rod, {1.0 * i, 0, 0});
        def.free[0].inertia = inertia;
        world.add(def);
        before = rod;
    }
    const double start = world.energy().total();
    run(world, 300);
    return start - world.energy().total();
}

// The rotor follows a change of its coordinate's rate by rotation one sub-step later, as in an inelastic
// impact; the energy lost is proportional to the sub-step.
TEST(Rotor, TakesLessEnergyFromADoublePendulumTheShorterTheStep) {
    const double scale = 2.0 * kGravity;  // J, of two rods that fall by a metre
    for (const double inertia : {0.01, 0.3, 5.0}) {
        const double coarse = energyLost(inertia, substeps(4)), fine = energyLost(inertia, substeps(32));
        EXPECT_LT(coarse, 0.05 * scale) << inertia;
        EXPECT_LT(fine, 0.02 * scale) << inertia;
        EXPECT_LT(fine, 0.5 * coarse) << inertia;
        EXPECT_GT(fine, -1e-3 * scale) << inertia;
    }
}

TEST(Rotor, SwingsASpringMoreSlowly) {
    // w^2 = k / (m + I): half a period after its release it is on the other side.
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), weight = world.add(ballOf(1, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, hook, weight, Vec3::Zero(), {1, 0, 0});
    def.free[0].inertia = 3.0;
    def.free[0].spring.stiffness = 4.0 * 3.14159265358979 * 3.14159265358979;  // of 4 kg: 0.5 Hz
    def.free[0].rest = 0.1;
    const JointId id = world.add(def);
    run(world, 60);
    EXPECT_NEAR(world.joint(id).position, 0.2, 1e-3);
    run(world, 60);
    EXPECT_NEAR(world.joint(id).position, 0.0, 1e-3);
}

TEST(Rotor, IsNotThrownOutward) {
    // On an arm that turns at W:  (m + I) r'' = m W^2 r. The centrifugal force acts only on m.
    World world(substeps(16));
    world.setGravity(Vec3::Zero());
    BodyDef turning = support::hook();
    turning.kind = BodyKind::kinematic;
    turning.spin = {0, 2, 0};
    const BodyId arm = world.add(turning), weight = world.add(ballOf(1, 0.1, {0.5, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, arm, weight, Vec3::Zero(), {1, 0, 0});
    def.free[0].inertia = 3.0;
    const JointId id = world.add(def);
    world.setVelocity(weight, {0, 0, -1}, {0, 2, 0});
    run(world, 60);
    EXPECT_NEAR(0.5 + world.joint(id).position, 0.5 * std::cosh(1.0), 2e-3);
}

TEST(Rotor, TakesTheSpeedThatABodyIsGiven) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), weight = world.add(ballOf(1, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, hook, weight, Vec3::Zero(), {1, 0, 0});
    def.free[0].inertia = 3.0;
    const JointId id = world.add(def);
    run(world, 10);
    world.setVelocity(weight, {1, 0, 0}, Vec3::Zero());
    run(world, 10);
    EXPECT_NEAR(world.joint(id).speed, 1.0, 1e-9);
    world.applyImpulse(weight, {1, 0, 0}, world.pose(weight).position);
    run(world, 10);
    EXPECT_NEAR(world.joint(id).speed, 1.25, 1e-9);  // P / (m + I)
}

}  // namespace
}  // namespace engine
