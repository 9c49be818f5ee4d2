/// Angles between two bodies, and how they change with w = w_b - w_a:   d(angle)/dt = rate . w
/// With (s, u) = q_b (q_a q_0)^-1, what b has turned as seen from a, and h fixed in a:
///   twist about h   phi = 2 atan2(u.h, s)
///                   ds/dt = -u.w / 2,   d(u.h)/dt = (s h - h x u).w / 2
///                   rate = (s^2 h - s h x u + (u.h) u) / (s^2 + (u.h)^2)
///   swing of h_b    theta = angle(h_a, h_b),   rate = h_a x h_b / |h_a x h_b|
///   of h_b around   alpha = atan2(q.h_b, p.h_b) for p, q fixed in a, across each other
///                   d(p.h_b)/dt = (h_b x p).w,   rate = (x (h_b x q) - y (h_b x p)) / (x^2 + y^2)
#pragma once
#include "engine/base/trigonometry.h"

namespace engine {

template <class Real>
struct Angle {
    Real value = Real(0);  // rad
    Vec3T<Real> rate = Vec3T<Real>::Zero();
};

template <class Real>
Real arctangentOf(Real y, Real x) {
    return static_cast<Real>(arctangent(static_cast<double>(y), static_cast<double>(x)));
}

/// The same angle, by whole turns as near as can be to `near`.
template <class Real>
Real counted(Real angle, Real near) {
    constexpr Real kTurn = static_cast<Real>(2.0 * kPi);
    return angle + kTurn * std::floor((near - angle) / kTurn + Real(0.5));
}

template <class Real>
Angle<Real> twistAbout(const Vec3T<Real>& h, const QuatT<Real>& turn, Real near = Real(0)) {
    const Real s = turn.w();
    const Vec3T<Real> u = turn.vec();
    const Real along = u.dot(h), size = s * s + along * along;
    if (size <= Real(0)) return {counted(Real(0), near), h};  // swung by half a turn: any twist
    return {counted(Real(2) * arctangentOf(along, s), near),
            (s * s * h - s * h.cross(u) + along * u) / size};
}

template <class Real>
Angle<Real> swingOf(const Vec3T<Real>& axisA, const Vec3T<Real>& axisB) {
    const Vec3T<Real> across = axisA.cross(axisB);
    const Real sine = across.norm();
    Vec3T<Real> rate, other;
    if (sine > Real(0))
        rate = across / sine;
    else
        tangents(axisA, rate, other);
    return {arctangentOf(sine, axisA.dot(axisB)), rate};
}

template <class Real>
Angle<Real> turnAround(const Vec3T<Real>& p, const Vec3T<Real>& q, const Vec3T<Real>& axisB,
                       Real near) {
    const Real x = p.dot(axisB), y = q.dot(axisB), size = x * x + y * y;
    if (size <= Real(0)) return {near, Vec3T<Real>::Zero()};
    return {counted(arctangentOf(y, x), near),
            (x * axisB.cross(q) - y * axisB.cross(p)) / size};
}

}  // namespace engine
