// Transmitted rotation: universal and constant velocity joints, gears.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/joints.h"

namespace engine {
namespace {

using support::ballOf;
using support::jointAt;
using support::kStep;
using support::run;

/// Two shafts that meet at the origin at the angle beta: the first is driven at 3 rad/s, the second is held
/// along its own axis.
struct Shafts {
    World world = support::weightless();
    BodyId first, second;
    Vec3 along1{0, 0, 1}, along2;
    JointId drive, joint;

    Shafts(JointType type, double beta) : along2(sine(beta), 0, cosine(beta)) {
        const BodyId hook = world.add(support::hook());
        first = world.add(ballOf(2, 0.1, {0, 0, -0.5}));
        BodyDef def = ballOf(1, 0.05, 0.5 * along2);
        def.pose.rotation = turnAbout(Vec3::UnitY(), beta);
        second = world.add(def);
        JointDef hinge = jointAt(world, JointType::hinge, hook, first, {0, 0, -0.5}, along1);
        hinge.free[0].motor = {3.0, kUnlimited};
        drive = world.add(hinge);
        // the pin of the first is in the plane of the shafts, that of the second perpendicular to it
        const bool pins = type == JointType::universal;
        joint = world.add(jointAt(world, type, first, second, Vec3::Zero(),
                                  pins ? Vec3::UnitX() : along1,
                                  pins ? Vec3::UnitY() : along2));
        world.add(jointAt(world, JointType::axis, hook, second, Vec3::Zero(), along2));
    }
    double speed1() const { return world.spin(first).dot(along1); }
    double speed2() const { return world.spin(second).dot(along2); }
};

// w2 / w1 = cos beta / (1 - sin^2 beta cos^2 alpha), alpha measured from the pin in the plane of the shafts
TEST(UniversalJoint, HandsOnTheSpeedOfCardansFormula) {
    for (const double degrees : {15.0, 30.0, 45.0}) {
        const double beta = radians(degrees);
        Shafts s(JointType::universal, beta);
        double low = 10.0, high = 0.0;
        for (int i = 0; i < 300; ++i) {
            s.world.step(kStep / 2);
            if (i < 10) continue;
            const double alpha = s.world.joint(s.drive).position;
            const double expected =
                cosine(beta) / (1 - sine(beta) * sine(beta) * cosine(alpha) * cosine(alpha));
            const double ratio = s.speed2() / s.speed1();
            EXPECT_NEAR(ratio, expected, 0.005);
            low = smaller(low, ratio), high = larger(high, ratio);
        }
        EXPECT_NEAR(low, cosine(beta), 0.005);
        EXPECT_NEAR(high, 1 / cosine(beta), 0.005);
        EXPECT_LT(s.world.joint(s.joint).separation, 1e-4);
    }
}

TEST(ConstantVelocityJoint, HandsOnTheSpeedAsItIs) {
    for (const double degrees : {15.0, 30.0, 45.0}) {
        Shafts s(JointType::constantVelocity, radians(degrees));
        EXPECT_NEAR(s.world.joint(s.joint).positions[1], radians(degrees), 1e-9);
        for (int i = 0; i < 300; ++i) {
            s.world.step(kStep / 2);
            if (i < 10) continue;
            EXPECT_NEAR(s.speed2() / s.speed1(), 1.0, 1e-3);
        }
        EXPECT_NEAR(s.world.joint(s.joint).positions[1], radians(degrees), 1e-3);
    }
}

// alpha = M / (I_a + r^2 I_b): the second wheel is weighted with the square of the ratio.
TEST(Gear, TurnsAtItsRatio) {
    for (const double ratio : {-2.0, 0.5}) {
        World world = support::weightless();
        const BodyId hook = world.add(support::hook());
        const BodyId a = world.add(ballOf(1, 0.3, {0, 0, 0})), b = world.add(ballOf(1, 0.1, {1, 0, 0}));
        JointDef hinge = jointAt(world, JointType::hinge, hook, a, {0, 0, 0});
        hinge.free[0].motor = {100.0, 2.0};
        const JointId first = world.add(hinge);
        const JointId second = world.add(jointAt(world, JointType::hinge, hook, b, {1, 0, 0}));
        JointDef gear = jointAt(world, JointType::gear, a, b, {0.5, 0, 0});
        gear.ratio = ratio;
        world.add(gear);
        run(world, 120);
        const double acceleration = 2.0 / (0.3 + ratio * ratio * 0.1);
        EXPECT_NEAR(world.joint(first).speed, 2 * acceleration, 0.01 * acceleration);
        EXPECT_NEAR(world.joint(second).speed, ratio * world.joint(first).speed, 1e-3);
        EXPECT_NEAR(world.joint(second).position, ratio * world.joint(first).position, 1e-3);
        EXPECT_GT(std::abs(world.joint(first).position), 2.0);
    }
}

// Axes may be at right angles, and a belt drives both wheels in the same direction.
TEST(Gear, JoinsAxesOfAnyDirection) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook());
    const BodyId a = world.add(ballOf(1, 0.3, {0, 0, 0})), b = world.add(ballOf(1, 0.1, {1, 0, 0}));
    const JointId first = world.add(jointAt(world, JointType::hinge, hook, a, {0, 0, 0}));
    const JointId second =
        world.add(jointAt(world, JointType::hinge, hook, b, {1, 0, 0}, {0, 3, 0}));
    JointDef gear = jointAt(world, JointType::gear, a, b, {0, 0, 0}, {0, 0, 1}, {0, 1, 0});
    gear.ratio = 3.0;
    world.add(gear);
    world.setVelocity(a, Vec3::Zero(), {0, 0, 4});
    run(world, 120);
    // I_a w_a + r I_b w_b is conserved: w_a = 4 * 0.3 / (0.3 + 9 * 0.1)
    EXPECT_NEAR(world.joint(first).speed, 1.0, 1e-4);
    EXPECT_NEAR(world.joint(second).speed, 3.0, 3e-4);
}

}  // namespace
}  // namespace engine
