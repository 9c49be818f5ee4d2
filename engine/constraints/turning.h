/// Angles between two bodies, and how they change with w = w_b - w_a:   d(angle)/dt = rate . w
/// With (s, u) = q_b (q_a q_0)^-1, the rotation of b relative to a, and h fixed in a:
///   twist about h   phi = 2 atan2(u.h, s)
///                   ds/dt = -u.w / 2,   d(u.h)/dt = (s h - h x u).w / 2
///                   rate = (s^2 h - s h x u + (u.h) u) / (s^2 + (u.h)^2)
///   swing of h_b    theta = angle(h_a, h_b),   rate = h_a x h_b / |h_a x h_b|
///   of h_b around   alpha = atan2(q.h_b, p.h_b) for p, q fixed in a, perpendicular
///                   d(p.h_b)/dt = (h_b x p).w,   rate = (x (h_b x q) - y (h_b x p)) / (x^2 + y^2)
/// An angle is undefined where its denominator is 0: a twist after a swing by half a turn, a turn around an axis that
/// h_b is parallel to. With m its square root, 1 where the axes fit,
///                   dm/dt = weightRate . w
#pragma once
#include "engine/base/trigonometry.h"

namespace engine {

struct Angle {
    double value = 0.0;  // rad
    Vec3 rate = Vec3::Zero();
    double weight = 1.0;  // m
    Vec3 weightRate = Vec3::Zero();
};

/// The same angle, changed by full turns to be as close as possible to `near`.
inline double unwrapped(double angle, double near) {
    constexpr double kTurn = 2.0 * kPi;
    return angle + kTurn * std::floor((near - angle) / kTurn + 0.5);
}

constexpr double kAsGoodAsOne = 1e-12;  // of 1 - m^2: joints that fit have round-off

inline Angle twistAbout(const Vec3& h, const Quat& turn, double near = 0.0) {
    const double s = turn.w();
    const Vec3 u = turn.vec();
    const double along = u.dot(h), size = s * s + along * along;
    if (size <= 0.0) return {unwrapped(0.0, near), h, 0.0};  // swung by half a turn: any twist
    Angle angle{unwrapped(2.0 * arctangent(along, s), near),
                (s * s * h - s * h.cross(u) + along * u) / size};
    if (1.0 - size < kAsGoodAsOne) return angle;
    angle.weight = std::sqrt(size);
    angle.weightRate = (along * (s * h - h.cross(u)) - s * u) / (2.0 * angle.weight);
    return angle;
}

/// 2 u.h, which is zero with the twist and defined at any swing.
inline Angle heldTwist(const Vec3& h, const Quat& turn) {
    const Vec3 u = turn.vec();
    return {2.0 * u.dot(h), turn.w() * h - h.cross(u)};
}

inline Angle swingOf(const Vec3& axisA, const Vec3& axisB) {
    const Vec3 across = axisA.cross(axisB);
    const double sine = across.norm();
    Vec3 rate, other;
    if (sine > 0.0)
        rate = across / sine;
    else
        tangents(axisA, rate, other);
    return {arctangent(sine, axisA.dot(axisB)), rate};
}

inline Angle turnAround(const Vec3& p, const Vec3& q, const Vec3& axisB, double near) {
    const double x = p.dot(axisB), y = q.dot(axisB), size = x * x + y * y;
    if (size <= 0.0) return {near, Vec3::Zero(), 0.0};
    Angle angle{unwrapped(arctangent(y, x), near),
                (x * axisB.cross(q) - y * axisB.cross(p)) / size};
    if (1.0 - size < kAsGoodAsOne) return angle;
    angle.weight = std::sqrt(size);
    angle.weightRate = (x * axisB.cross(p) + y * axisB.cross(q)) / angle.weight;
    return angle;
}

}  // namespace engine
