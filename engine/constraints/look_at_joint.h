/// Look-at: an axis of b points from its anchor to the anchor of a.
///   C = t.d   for two t perpendicular to the axis, fixed in b;  d = p_b - p_a
///   dC/dt = (w_b x t).d + t.(v_b + w_b x r_b - v_a - w_a x r_a)
///   J = [-t, -(r_a x t), t, (r_b - d) x t]                      the arm of b reaches to p_a
/// Pointing away from the anchor is also a solution: if the axis is at more than a right angle to
/// the line of sight when the joint is made, it settles there. (Second seed, 'Pointing towards a
/// point'.)
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

inline void addLookAtRows(const JointGeometry& g, JointRows& rows) {
    for (const Vec3& across : g.acrossB)
        rows.add(alongDirection(across, g.armA, Vec3(g.armB - g.between)), across.dot(g.between));
}

}  // namespace engine
