/// Slider: b moves along an axis of a and does not turn.
///   C = t.d   for the two t across the axis, fixed in a;  d = p_b - p_a
///   dC/dt = (w_a x t).d + t.(v_b + w_b x r_b - v_a - w_a x r_a)
///   J = [-t, -((r_a + d) x t), t, r_b x t]                      the arm of a reaches to p_b
///   and b does not turn, as in a weld                           three rows
/// Free is the way along the axis h, C = h.d with the same J.
#pragma once
#include "engine/constraints/weld_joint.h"

namespace engine {

/// Of the way along n, fixed in a, from a's anchor to b's.
template <class Real>
Jacobian<Real> alongFixedInA(const Vec3T<Real>& n, const JointGeometry<Real>& g) {
    return alongDirection<Real>(n, Vec3T<Real>(g.armA + g.between), g.armB);
}

template <class Real>
void addAcrossRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    for (const Vec3T<Real>& across : g.acrossA)
        rows.add(alongFixedInA<Real>(across, g), across.dot(g.between));
}

template <class Real>
void addSliderRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    addAcrossRows(g, rows);
    addTurnRows(g, rows);
}

template <class Real>
void addSliderCoordinate(const JointGeometry<Real>& g, JointRows<Real>& coordinates) {
    coordinates.add(alongFixedInA<Real>(g.axisA, g), g.axisA.dot(g.between));
}

}  // namespace engine
