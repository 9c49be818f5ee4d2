/// The prescribed pose of a kinematic body, as a function of time alone.
///   points   straight from one to the next, or smooth: cubic Hermite curves with the tangents
///            m_i = (p_{i+1} - p_{i-1}) / (t_{i+1} - t_{i-1}), at rest at either end
///   orbit    p(t) = c + R(w t) (p_0 - c)
/// The engine takes velocities. v = (p(t + dt) - x) / dt, from the actual position x, leads to the
/// prescribed one at the step's end, so that errors do not accumulate.
#pragma once
#include <variant>
#include <vector>

#include "engine/base/math.h"

namespace demos {

struct PointPath {
    std::vector<engine::Vec3> points;  // m, at least two
    std::vector<double> times;         // s, from 0, rising; as many
    bool loop = false;                 // endless; the last point is the first
    bool smooth = false;
    engine::Vec3 spin{0, 0, 0};        // rad/s, about the body's own centre
};

struct Orbit {
    engine::Vec3 centre{0, 0, 0};  // m
    engine::Vec3 axis{0, 1, 0};    // unit
    double rate = 1.0;             // w, rad/s
    bool turns = true;             // the body turns with it, like the hand of a clock
};

using KinematicPath = std::variant<PointPath, Orbit>;

/// `start`: the pose at time 0.
engine::Pose poseAt(const KinematicPath& path, const engine::Pose& start, double time);

/// The velocities that lead from one pose to the other within dt (s), by the shorter rotation.
struct Twist {
    engine::Vec3 velocity, spin;  // m/s, rad/s
};
Twist twistBetween(const engine::Pose& from, const engine::Pose& to, double dt);

}  // namespace demos
