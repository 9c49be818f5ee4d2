/// Joints for tests.
#pragma once
#include "tests/support/worlds.h"

namespace support {

using engine::Freedom;
using engine::JointDef;
using engine::JointState;

/// A joint at a point in world axes, to be completed and added.
inline JointDef jointAt(const World& world, JointType type, BodyId a, BodyId b, const Vec3& at,
                        const Vec3& axis = Vec3::UnitZ(), const Vec3& axis2 = Vec3::Zero()) {
    JointDef def;
    def.type = type;
    def.a = a, def.b = b, def.axis = axis, def.axis2 = axis2;
    def.anchorA = world.pose(a).toLocal(at);
    def.anchorB = world.pose(b).toLocal(at);
    return def;
}

/// A box of 10 g to 100 kg and 2 to 40 cm, thrown at up to 20 rad/s about each axis.
inline BodyDef thrownBox(Random& random, const Vec3& at) {
    const double mass = std::pow(10.0, random.number(-2, 2));
    const Vec3 size{0.4, random.number(0.05, 0.4), random.number(0.02, 0.4)};
    BodyDef box = body(Shape::box(size), at, mass);
    box.velocity = random.vector(2), box.spin = random.vector(20);
    return box;
}

/// A ball with the same inertia about every axis, which nothing touches.
inline BodyDef ballOf(double mass, double inertia, const Vec3& at) {
    BodyDef def = body(Shape::sphere(0.1), at, mass);
    def.inertia = engine::Mat3(inertia * engine::Mat3::Identity());
    def.collide = false;
    return def;
}

inline World weightless(const Settings& settings = Settings::steady()) {
    World world(settings);
    world.setGravity(Vec3::Zero());
    return world;
}

}  // namespace support
