/// Small worlds for tests, each made with one line.
#pragma once
#include <cmath>
#include <vector>

#include "engine/world.h"

namespace support {

using engine::BodyDef;
using engine::BodyId;
using engine::BodyKind;
using engine::JointId;
using engine::JointType;
using engine::Quat;
using engine::Settings;
using engine::Shape;
using engine::Vec3;
using engine::World;

constexpr double kStep = 1.0 / 60.0;  // s
constexpr double kGravity = 9.81;     // m/s^2

inline engine::Pose at(const Vec3& position, const Quat& rotation = Quat::Identity()) {
    return {position, rotation};
}

inline BodyDef body(const Shape& shape, const Vec3& at, double mass = 1.0) {
    BodyDef def;
    def.shape = shape;
    def.pose.position = at;
    def.mass = mass;
    return def;
}

inline BodyDef fixed(const Shape& shape, const Vec3& at = Vec3::Zero()) {
    BodyDef def;
    def.kind = BodyKind::fixed;
    def.shape = shape;
    def.pose.position = at;
    return def;
}

inline BodyDef floorPlane() { return fixed(Shape::plane(Vec3::UnitY())); }

/// The turn about z that takes the x axis to a direction in the xy plane.
inline Quat turnInPlane(const Vec3& way) {
    return Quat(Eigen::AngleAxisd(std::atan2(way.y(), way.x()), Vec3::UnitZ()));
}

/// A point for joints to hang on; nothing collides with it.
inline BodyDef hook(const Vec3& at = Vec3::Zero()) {
    BodyDef def = fixed(Shape::sphere(0.01), at);
    def.collide = false;
    return def;
}

/// A joint between two bodies at a point in world axes.
inline JointId join(World& world, JointType type, BodyId a, BodyId b, const Vec3& at,
                    const Vec3& axis = Vec3::UnitZ()) {
    engine::JointDef def;
    def.type = type;
    def.a = a, def.b = b, def.axis = axis;
    def.anchorA = world.pose(a).toLocal(at);
    def.anchorB = world.pose(b).toLocal(at);
    return world.add(def);
}

/// A rod between the centres of two bodies.
inline JointId rod(World& world, BodyId a, BodyId b) {
    engine::JointDef def;
    def.type = JointType::distance;
    def.a = a, def.b = b;
    def.length = (world.pose(b).position - world.pose(a).position).norm();
    return world.add(def);
}

inline void run(World& world, int steps, double dt = kStep) {
    for (int i = 0; i < steps; ++i) world.step(dt);
}

/// `count` unit cubes on a floor, the lowest first; body 0 is the floor.
inline World stack(int count, const Settings& settings = Settings::steady(), double friction = 0.6,
                   double mass = 1000.0) {
    World world(settings);
    BodyDef ground = floorPlane();
    ground.material.friction = friction;
    world.add(ground);
    for (int i = 0; i < count; ++i) {
        BodyDef box = body(Shape::box({1, 1, 1}), {0, i + 0.5, 0}, mass);
        box.material.friction = friction;
        world.add(box);
    }
    return world;
}

/// Random numbers without a library: the same on every machine (Steele et al. 2014, splitmix64).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// Uniform in [low, high).
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1.0p-53;
    }
    Vec3 vector(double reach) {
        const double x = number(-reach, reach), y = number(-reach, reach);
        return {x, y, number(-reach, reach)};
    }
    Quat rotation() {
        const double w = number(-1, 1);
        const Vec3 v = vector(1);
        return Quat(w, v.x(), v.y(), v.z()).normalized();
    }

private:
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

}  // namespace support
