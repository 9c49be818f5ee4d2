/// Slider: b moves along an axis of a without rotating.
///   C = t.d   for two t perpendicular to the axis, fixed in a;  d = p_b - p_a
///   dC/dt = (w_a x t).d + t.(v_b + w_b x r_b - v_a - w_a x r_a)
///   J = [-t, -((r_a + d) x t), t, r_b x t]                      the arm of a reaches to p_b
///   and no relative rotation, as in a weld                      three rows
/// The translation along the axis h is free, C = h.d with the same J.
#pragma once
#include "engine/constraints/weld_joint.h"

namespace engine {

/// J of the distance along n (fixed in a) from a's anchor to b's.
inline Jacobian alongFixedInA(const Vec3& n, const JointGeometry& g) {
    return alongDirection(n, Vec3(g.armA + g.between), g.armB);
}

inline void addAcrossRows(const JointGeometry& g, JointRows& rows) {
    for (const Vec3& across : g.acrossA) rows.add(alongFixedInA(across, g), across.dot(g.between));
}

inline void addSliderRows(const JointGeometry& g, JointRows& rows) {
    addAcrossRows(g, rows);
    addTurnRows(g, rows);
}

inline void addSliderCoordinate(const JointGeometry& g, JointRows& coordinates) {
    coordinates.add(alongFixedInA(g.axisA, g), g.axisA.dot(g.between));
}

}  // namespace engine
