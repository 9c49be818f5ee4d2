/// What the scenes are made of.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tests/benchmark/peer_scenes.h"

namespace peers {

constexpr double kGravity = 9.81;  // m/s^2
constexpr double kPi = std::numbers::pi;

/// Numbers without a library: the same on every machine (Knuth's multiplier; the upper 31 bits).
class Lcg {
public:
    /// Uniform in [low, high).
    double number(double low, double high) {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        const double share = static_cast<double>((state_ >> 33) & 0x7fffffff) / 2147483648.0;
        return low + (high - low) * share;
    }

private:
    std::uint64_t state_ = 12345;
};

inline Body box(const Vec3& halfSize, const Vec3& at, double density = 1000.0) {
    Body body;
    body.halfSize = halfSize, body.pose.position = at, body.density = density;
    return body;
}

inline Body sphere(double radius, const Vec3& at, double density = 1000.0) {
    Body body;
    body.kind = Kind::sphere;
    body.radius = radius, body.pose.position = at, body.density = density;
    return body;
}

inline Body cube(const Vec3& at, double density = 1000.0) { return box({.5, .5, .5}, at, density); }

inline Body fixed(Body body) {
    body.dynamic = false;
    return body;
}

inline Body ghost(Body body) {
    body.collide = false;
    return body;
}

inline Quat turn(const Vec3& axis, double angle) {
    const double x = axis.x(), y = axis.y(), z = axis.z();
    const double s = std::sin(angle / 2) / std::sqrt(x * x + y * y + z * z);
    return Quat(std::cos(angle / 2), x * s, y * s, z * s);
}

inline int add(Scene& scene, const Body& body) {
    scene.bodies.push_back(body);
    return static_cast<int>(scene.bodies.size()) - 1;
}

inline void addBall(Scene& scene, int a, int b, const Vec3& at) {
    scene.joints.push_back({false, a, b, at});
}

inline void addHinge(Scene& scene, int a, int b, const Vec3& at) {
    scene.joints.push_back({true, a, b, at, {0, 0, 1}});
}

/// Its top is y = 0.
inline void addFloor(Scene& scene, double half = 100) {
    add(scene, fixed(box({half, 1, half}, {0, -1, 0})));
    scene.lostBelow = -5.0;
}

// peer_crowds.cpp: scenes with many bodies, and shapes other than boxes and spheres.
Scene ragdolls();
Scene meshCrowd();
Scene hullPile();
Scene turningDrum();
Scene manyPyramids();
Scene spacedCubes(int side, bool resting);
Scene asleep();
Scene wheelBesidePyramid();
Scene thrownRods();

/// A chain of links released level: joints that carry each other's weight.
Scene chain(int links);
Scene pyramid(int base);

}  // namespace peers
