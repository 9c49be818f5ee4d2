#include "demos/scene/kinematic_path.h"

#include <algorithm>
#include <cmath>

#include "engine/base/trigonometry.h"

namespace demos {
namespace {

using engine::Pose;
using engine::Quat;
using engine::Vec3;

Quat turned(const Vec3& spin, double time) {
    const double rate = spin.norm();
    return rate > 0.0 ? engine::turnAbout(spin / rate, rate * time) : Quat::Identity();
}

/// m_i
Vec3 tangentAt(const PointPath& path, std::size_t i) {
    const std::vector<Vec3>& p = path.points;
    const std::vector<double>& t = path.times;
    const std::size_t last = p.size() - 1;
    if (i > 0 && i < last) return (p[i + 1] - p[i - 1]) / (t[i + 1] - t[i - 1]);
    if (!path.loop) return Vec3::Zero();
    return (p[1] - p[last - 1]) / (t[1] - t[0] + t[last] - t[last - 1]);
}

Vec3 pointAt(const PointPath& path, double time) {
    const std::vector<double>& t = path.times;
    if (path.loop) time = std::fmod(time, t.back());
    if (time >= t.back()) return path.points.back();
    const auto next = std::upper_bound(t.begin(), t.end(), time);
    const std::size_t i = static_cast<std::size_t>(next - t.begin()) - 1;
    const double span = t[i + 1] - t[i], s = (time - t[i]) / span;
    const Vec3 &p = path.points[i], &q = path.points[i + 1];
    if (!path.smooth) return p + s * (q - p);
    const Vec3 m = span * tangentAt(path, i), n = span * tangentAt(path, i + 1);
    const double s2 = s * s, s3 = s2 * s;
    return p + (3.0 * s2 - 2.0 * s3) * (q - p) + (s3 - 2.0 * s2 + s) * m + (s3 - s2) * n;
}

Pose poseOn(const PointPath& path, const Pose& start, double time) {
    return {pointAt(path, time), turned(path.spin, time) * start.rotation};
}

Pose poseOn(const Orbit& orbit, const Pose& start, double time) {
    const Quat turn = engine::turnAbout(orbit.axis, orbit.rate * time);
    return {orbit.centre + turn * (start.position - orbit.centre),
            orbit.turns ? turn * start.rotation : start.rotation};
}

}  // namespace

Pose poseAt(const KinematicPath& path, const Pose& start, double time) {
    return std::visit([&](const auto& way) { return poseOn(way, start, time); }, path);
}

Twist twistBetween(const Pose& from, const Pose& to, double dt) {
    Quat turn = to.rotation * from.rotation.conjugate();
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    const double angle = 2.0 * engine::arctangent(sine, turn.w());
    Twist twist{(to.position - from.position) / dt, Vec3::Zero()};
    if (sine > 0.0) twist.spin = angle / (sine * dt) * turn.vec();
    return twist;
}

}  // namespace demos
