/// Weld: no relative motion.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = 2 u,  where (s, u) = q_b (q_a q_0)^-1 is the rotation error of b, q_0 = q_a^-1 q_b at the start;
///   from dq/dt = (0, w) q / 2:
///   dC/dt = (s - [u]) w_b - (s + [u]) w_a,   [u] y = u x y
/// For small errors C is the rotation vector, in rad.
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

/// b does not rotate relative to a.
inline void addTurnRows(const JointGeometry& g, JointRows& rows) {
    Quat tooFar = g.turnB * (g.turnA * g.turnAtStart).conjugate();
    if (tooFar.w() < 0.0) tooFar.coeffs() = -tooFar.coeffs();  // the shorter rotation
    const Vec3 u = tooFar.vec();
    const Mat3 s = tooFar.w() * Mat3::Identity();
    const Mat3 turnA = -(s + crossMatrix(u));
    const Mat3 turnB = s - crossMatrix(u);
    for (int i = 0; i < 3; ++i)
        rows.add({Vec3::Zero(), turnA.row(i).transpose(), turnB.row(i).transpose()}, 2.0 * u[i]);
}

inline void addWeldRows(const JointGeometry& g, JointRows& rows) {
    addBallRows(g, rows);
    addTurnRows(g, rows);
}

}  // namespace engine
