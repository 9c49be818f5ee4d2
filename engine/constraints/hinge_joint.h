/// Hinge: a point in common, and an axis in common.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = t.h_b   for the two t across a's axis, fixed in a;  h_b is the axis fixed in b
///   dC/dt = (w_a x t).h_b + t.(w_b x h_b) = (t x h_b).(w_a - w_b)
///   J = [0, t x h_b, 0, -(t x h_b)]
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

template <class Real>
void addHingeRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    addBallRows(g, rows);
    for (const Vec3T<Real>& across : g.acrossA) {
        const Vec3T<Real> turn = across.cross(g.axisB);
        rows.add({Vec3T<Real>::Zero(), turn, Vec3T<Real>(-turn)}, across.dot(g.axisB));
    }
}

}  // namespace engine
