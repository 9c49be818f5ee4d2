/// Weld: no relative motion.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = 2 u,  where (s, u) = q_b (q_a q_0)^-1 is what b is turned too far, q_0 = q_a^-1 q_b at first;
///   from dq/dt = (0, w) q / 2:
///   dC/dt = (s - [u]) w_b - (s + [u]) w_a,   [u] y = u x y
/// For small errors C is the rotation vector, in rad.
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

/// b does not turn as seen from a.
template <class Real>
void addTurnRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    QuatT<Real> tooFar = g.turnB * (g.turnA * g.turnAtStart).conjugate();
    if (tooFar.w() < Real(0)) tooFar.coeffs() = -tooFar.coeffs();  // the short way round
    const Vec3T<Real> u = tooFar.vec();
    const Mat3T<Real> s = tooFar.w() * Mat3T<Real>::Identity();
    const Mat3T<Real> turnA = -(s + crossMatrix<Real>(u));
    const Mat3T<Real> turnB = s - crossMatrix<Real>(u);
    for (int i = 0; i < 3; ++i)
        rows.add({Vec3T<Real>::Zero(), turnA.row(i).transpose(), turnB.row(i).transpose()},
                 Real(2) * u[i]);
}

template <class Real>
void addWeldRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    addBallRows(g, rows);
    addTurnRows(g, rows);
}

}  // namespace engine
