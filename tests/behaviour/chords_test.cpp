// Joints outside the trees, limits, and trees beside them follow the chord (solver/chords.h): they keep angular
// momentum and energy. Along the tangent a taut rope lost 26 % of one and 44 % of the other in half a minute.
#include <gtest/gtest.h>

#include <string>

#include "engine/base/trigonometry.h"
#include "tests/support/joints.h"

namespace engine {
namespace {

using support::jointAt;
using support::kGravity;
using support::kStep;
using support::run;

const Settings kChordPresets[] = {Settings::steady(), Settings::fast()};

BodyDef passing(const Shape& shape, const Vec3& at, double mass) {
    BodyDef def = support::body(shape, at, mass);
    def.collide = false;
    return def;
}

/// kg m^2/s about the origin.
Vec3 spinOf(const World& world) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < world.bodyCount(); ++i) {
        const BodyId id{i};
        const Pose& pose = world.pose(id);
        const Vec3 own = world.inertia(id) * (pose.rotation.conjugate() * world.spin(id));
        sum += world.mass(id) * pose.position.cross(world.velocity(id)) + pose.rotation * own;
    }
    return sum;
}

/// Two boxes that turn about each other, joined in different ways.
JointDef pairJoint(const std::string& how, const World& world) {
    const JointType type = how == "slider"    ? JointType::slider
                           : how == "six"     ? JointType::sixDof
                           : how == "rope"    ? JointType::distance
                           : how == "wheel"   ? JointType::wheel
                           : how == "look-at" ? JointType::lookAt
                                              : JointType::path;
    JointDef joint = jointAt(world, type, {0}, {1}, Vec3(0.5, 0, 0), {1, 0, 0});
    if (how == "slider") joint.free[0].limits = {0.0, 1e-3};
    if (how == "rope") joint.anchorA = joint.anchorB = Vec3::Zero(), joint.length = 1.0;
    if (how == "rope") joint.free[0].limits = {0.5, 1.0};
    if (how == "wheel") joint.axis = Vec3::UnitY(), joint.axis2 = Vec3::UnitZ();
    if (how == "path")  // in the axes of the first, and through the centre of the second
        joint.anchorB = Vec3::Zero(), joint.path = {{1, -2, 0}, {1, -1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}};
    if (how == "wheel" || how == "path") joint.free[0].spring = {2.0, 0.0};
    if (how != "six") return joint;
    for (int i = 0; i < 6; ++i) joint.free[i].locked = i > 0;
    joint.free[0].limits = {0.0, 1e-3};
    return joint;
}

TEST(Chords, KeepTheAngularMomentumOfTwoThatTurnAboutEachOther) {
    for (const Settings& settings : kChordPresets)
        for (const char* how : {"slider", "six", "rope", "wheel", "path", "look-at"}) {
            World world(settings);
            world.setGravity(Vec3::Zero());
            for (const double side : {-1.0, 1.0}) {
                BodyDef def = passing(Shape::box({0.8, 0.1, 0.2}), {0.5 * side, 0, 0}, 1.0);
                def.velocity = {0, 1.5 * side, 0}, def.spin = {0, 0, 3};
                world.add(def);
            }
            world.add(pairJoint(how, world));
            const Vec3 start = spinOf(world);
            run(world, 1200);
            EXPECT_LT((spinOf(world) - start).norm(), 0.02 * start.norm()) << how;
        }
}

TEST(Chords, KeepABeadOnARingAtItsSpeed) {
    for (const Settings& settings : kChordPresets) {
        World world(settings);
        world.setGravity(Vec3::Zero());
        BodyDef def = passing(Shape::sphere(0.1), {2, 0, 0}, 10.0);
        def.velocity = {0, 0, 5};
        const BodyId bead = world.add(def);
        JointDef path;
        path.type = JointType::path, path.a = world.add(support::hook()), path.b = bead, path.closed = true;
        for (double angle = 0.0; angle < 359.0; angle += 30.0)
            path.path.push_back({2.0 * cosine(radians(angle)), 0, 2.0 * sine(radians(angle))});
        world.add(path);
        run(world, 3600);
        EXPECT_NEAR(world.velocity(bead).norm(), 5.0, 0.02);
    }
}

// Released level, its highest point stays there; every swing lost a sixtieth.
TEST(Chords, KeepARopePendulumSwinging) {
    for (const Settings& settings : kChordPresets) {
        World world(settings);
        const BodyId hook = world.add(support::hook()), ball = world.add(passing(Shape::sphere(0.1), {2, 0, 0}, 5.0));
        JointDef rope;
        rope.type = JointType::distance, rope.a = hook, rope.b = ball, rope.length = 2.0;
        rope.free[0].limits = {0.0, 2.0};
        world.add(rope);
        run(world, 1800);
        EXPECT_NEAR(world.energy().total(), 0.0, 0.02 * 5.0 * kGravity * 2.0);
    }
}

// The wheel's plate swings on a hinge, which is a tree that the wheel acts on.
TEST(Chords, KeepTheEnergyOfTreesBesideOtherJoints) {
    for (const Settings& settings : kChordPresets) {
        World world(settings);
        BodyDef plate = passing(Shape::box({1, 0.1, 1}), {0, 0, 0}, 10.0);
        BodyDef wheel = passing(Shape::cylinder(0.3, 0.1), {0.4, -0.1, 0.6}, 2.0);
        wheel.pose.rotation = turnAboutXyz({radians(90), 0, 0}), wheel.spin = {0, 0, 20};
        const BodyId hook = world.add(support::hook()), a = world.add(plate), b = world.add(wheel);
        world.add(jointAt(world, JointType::hinge, hook, a, {-0.6, 0, 0}));
        JointDef joint = jointAt(world, JointType::wheel, a, b, wheel.pose.position, Vec3::UnitY(), Vec3::UnitZ());
        joint.free[0].spring = {3.0, 0.0};
        world.add(joint);
        const double start = world.energy().total();
        run(world, 1800);
        EXPECT_NEAR(world.energy().total(), start, 2.0) << "of 93 J of motion";
    }
}

}  // namespace
}  // namespace engine
