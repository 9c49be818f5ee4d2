// Joints that constrain only directions: axis and look-at.
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

// A tray stays level while it falls and spins freely: positions and the rotation about the axis are
// free.
TEST(AxisJoint, KeepsADirectionAndNothingElse) {
    World world;
    const BodyId hook = world.add(support::hook());
    BodyDef def = ballOf(2, 0.1, {3, 1, 0});
    def.inertia = Mat3(Vec3(0.1, 0.2, 0.3).asDiagonal());
    const BodyId tray = world.add(def);
    const JointId id =
        world.add(jointAt(world, JointType::axis, hook, tray, Vec3::Zero(), Vec3::UnitY()));
    world.setVelocity(tray, {1, 0, 0}, {0.5, 2, -0.7});
    run(world, 120);
    EXPECT_LT((world.pose(tray).rotation * Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-6);
    EXPECT_NEAR(world.pose(tray).position.x(), 5.0, 1e-9);
    EXPECT_NEAR(world.spin(tray).y(), 2.0, 1e-6);
    EXPECT_NEAR(world.joint(id).position, 4.0, 1e-4);
    EXPECT_NEAR(world.joint(id).force.norm(), 0.0, 1e-12);
}

// Another axis of b is aligned with the axis of a.
TEST(AxisJoint, BringsTwoDirectionsTogether) {
    World world = support::weightless();
    const BodyId hook = world.add(support::hook()), arrow = world.add(ballOf(2, 0.1, {3, 1, 0}));
    world.add(jointAt(world, JointType::axis, hook, arrow, Vec3::Zero(), Vec3::UnitY(),
                      Vec3(1, 0.3, 0.2)));
    const Vec3 local = Vec3(1, 0.3, 0.2).normalized();
    run(world, 60);
    EXPECT_LT((world.pose(arrow).rotation * local - Vec3::UnitY()).norm(), 1e-5);
}

// A lamp on its stand follows a passing body (second seed, 'Pointing towards a point').
TEST(LookAtJoint, PointsAtWhatMoves) {
    World world;
    BodyDef target = support::hook({0, 2, 4});
    target.kind = BodyKind::kinematic;
    target.velocity = {1.5, 0.5, 0};
    const BodyId fly = world.add(target), stand = world.add(support::hook());
    const BodyId lamp = world.add(ballOf(1, 0.1, {0, 0, 0}));
    world.add(jointAt(world, JointType::ball, stand, lamp, Vec3::Zero()));
    JointDef def = jointAt(world, JointType::lookAt, fly, lamp, Vec3::Zero(), Vec3(0.1, 0, 1));
    def.anchorA = Vec3::Zero();
    world.add(def);
    const Vec3 local = Vec3(0.1, 0, 1).normalized();
    run(world, 30);
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        const Vec3 sight = (world.pose(fly).position - world.pose(lamp).position).normalized();
        EXPECT_LT((world.pose(lamp).rotation * local - sight).norm(), 1e-3);
    }
    EXPECT_NEAR(world.spin(lamp).dot(world.pose(lamp).rotation * local), 0.0, 0.05);
}

}  // namespace
}  // namespace engine
