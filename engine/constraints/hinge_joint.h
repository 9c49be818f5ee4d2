/// Hinge: a point in common, and an axis in common.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = t.h_b   for the two t across a's axis, fixed in a;  h_b is the axis fixed in b
///   dC/dt = (w_a x t).h_b + t.(w_b x h_b) = (t x h_b).(w_a - w_b)
///   J = [0, t x h_b, 0, -(t x h_b)]
/// Free is the angle about the axis (turning.h), turns counted.
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

/// An axis of b stays parallel to the one of a that the two `across` are across.
template <class Real>
void addParallelRows(const Vec3T<Real> (&acrossA)[2], const Vec3T<Real>& axisB,
                     JointRows<Real>& rows) {
    for (const Vec3T<Real>& across : acrossA) {
        const Vec3T<Real> turn = across.cross(axisB);
        rows.add({Vec3T<Real>::Zero(), turn, Vec3T<Real>(-turn)}, across.dot(axisB));
    }
}

template <class Real>
void addHingeRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    addBallRows(g, rows);
    addParallelRows(g.acrossA, g.axisB, rows);
}

template <class Real>
void addHingeCoordinate(const JointGeometry<Real>& g, JointRows<Real>& coordinates) {
    addTurn(twistAbout<Real>(g.axisA, turnSinceStart(g), g.near[0]), coordinates);
}

}  // namespace engine
