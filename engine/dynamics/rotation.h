/// Integrates spin and rotation of a free body over a time h.
///
/// Without torque L = I w is constant. In body axes it is M = R^T L, the spin is W = I^-1 M, and
///   dM/dt = M x W,   dq/dt = q (0, W) / 2
/// The right sides are products, so the terms of the power series in t follow recursively:
///   (k + 1) M_k+1 = sum_j M_j x W_k-j,   (k + 1) q_k+1 = sum_j q_j (0, W_k-j) / 2,   j = 0 .. k
/// They are summed until the next one is below 1e-12; if that takes too many terms (a fast body), the time is
/// divided. A series needs only sums and products, so its bits are the same everywhere.
///
/// A symmetric top, with the moment c about its axis d and a about the others, turns steadily about d and
/// about L:
///   w = L / a + u d,   u = (1 - c / a) w.d is constant,   q1 = turn(h L / a) turn(h u d) q
///
/// This is Gyroscope::momentum. The others are for comparison:
///   implicitEuler  one Newton step on I dw/dt = -w x I w (Catto, GDC 2015, 'Numerical Methods'):
///                  stable, but the energy decays: -26 % in 60 s on the free spin of tests/behaviour
///   none           w is constant: a body spun about its middle axis never flips
#pragma once
#include "engine/base/math.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// q / |q| of a q whose length is 1 but for rounding: one step of Newton's method for 1 / |q|.
template <class Real>
[[gnu::always_inline]] inline Eigen::Quaternion<Real> renormalized(const Eigen::Quaternion<Real>& q) {
    return Eigen::Quaternion<Real>((Real(1.5) - Real(0.5) * q.squaredNorm()) * q.coeffs());
}

/// q turned by the small rotation vector `turn` (rad, world axes), by the Cayley map
///   q1 = (1, turn / 2) q / |...|
inline Quat cayley(const Vec3& turn, const Quat& q) {
    const Vec3 half = 0.5 * turn;
    Quat turned = Quat(1.0, half.x(), half.y(), half.z()) * q;
    turned.normalize();
    return turned;
}

/// q turned by the rotation vector `turn` (rad, world axes), of any length:
///   q1 = (cos(|turn| / 2), sin(|turn| / 2) turn / |turn|) q
Quat turnedBy(const Vec3& turn, const Quat& q);

/// Sets the rotation of a body and turns its spin with it, which keeps its energy, w . I w.
inline void turnTo(const Quat& rotation, int body, Bodies& bodies) {
    Quat& before = bodies.poses[body].rotation;
    Vec3& spin = bodies.velocities[body].angular;
    if (!bodies.masses[body].isRound) spin = rotation * (before.conjugate() * spin);
    before = rotation;
}

/// The rotation from one pose to another (rad, world axes), below one radian: 2 sin(angle / 2) times its
/// axis.
inline Vec3 turnBetween(const Pose& from, const Pose& to) {
    const Quat turn = to.rotation * from.rotation.conjugate();
    return turn.w() < 0.0 ? Vec3(-2.0 * turn.vec()) : Vec3(2.0 * turn.vec());
}

/// The spin after a time h under its own gyroscopic torque: one Newton step of implicit Euler.
Vec3 spinAfterGyroscopicTorque(const BodyMass& mass, const Quat& rotation, const Vec3& spin,
                               double h);

/// Rotation and spin after a time h with constant L = I w.
void turnKeepingMomentum(const BodyMass& mass, double h, Quat& rotation, Vec3& spin);

/// The same for two bodies at once, with the same bits. `mass` has the same kind (kindOfTurn) for both.
struct Turn {
    const BodyMass* mass = nullptr;
    double h = 0.0;  // s
    Quat* rotation = nullptr;
    Vec3* spin = nullptr;
};
void turnTwo(const Turn& a, const Turn& b);
/// 0: ball or cube, 1: symmetric top, 2: any other.
inline int kindOfTurn(const BodyMass& mass) { return mass.isRound ? 0 : mass.topAxis >= 0 ? 1 : 2; }

}  // namespace engine
