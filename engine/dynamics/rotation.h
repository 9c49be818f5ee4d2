/// How a free body's spin and rotation are carried over a time h.
///
/// Turning by the constant spin w for a time h is done by the Cayley map
///   q1 = (1, h w / 2) q0 / |...|
/// which is also q + h/2 (0, w) q, normalised. It needs no sine, so its bits are the same everywhere.
///
/// The torque-free equation is I dw/dt = -w x I w (body axes). Left out (Gyroscope::none), a body spun
/// about its middle axis never flips. Explicit, the energy grows without bound.
///   implicitEuler  one Newton step on the implicit equation (Catto, GDC 2015, 'Numerical Methods'):
///                  stable, but the energy decays: -26 % in 60 s on the free spin of tests/behaviour
///   momentum       L = I w is kept to the last bit and w follows from it at mid-step:
///                    q_half = cayley(h/2 w0) q0,  w_half = R_half I^-1 R_half^T L,
///                    q1 = cayley(h w_half) q0,    w1 = R1 I^-1 R1^T L
#pragma once
#include "engine/base/math.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// q turned by the rotation vector `turn` (rad, world axes), by the Cayley map.
inline Quat cayley(const Vec3& turn, const Quat& q) {
    const Vec3 half = 0.5 * turn;
    Quat turned = Quat(1.0, half.x(), half.y(), half.z()) * q;
    turned.normalize();
    return turned;
}

/// The spin after a time h under its own gyroscopic torque: one Newton step of implicit Euler.
Vec3 spinAfterGyroscopicTorque(const BodyMass& mass, const Quat& rotation, const Vec3& spin,
                               double h);

/// Rotation and spin after a time h with L = I w kept.
void turnKeepingMomentum(const BodyMass& mass, double h, Quat& rotation, Vec3& spin);

}  // namespace engine
