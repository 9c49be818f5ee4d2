/// Path: a point of b stays on a curve fixed in a (catmull_rom.h); b may turn as it likes.
///   C = t.d   for the two t across the curve where it is nearest;  d = p_b - p(s), d.p' = 0
///   dC/dt = t.(v_b + w_b x r_b - v_a - w_a x (r_b + x_b - x_a)) + t.(-p' ds/dt) + (dt/ds).d ds/dt
///   J = [-t, -((x_b + r_b - x_a) x t), t, r_b x t]
/// The second term is zero, the third is of the order of C. Free is the way along the curve, m from
/// its first point; beyond an end the curve goes on straight.
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

inline void addPathRows(const JointGeometry& g, JointRows& rows) {
    for (const Vec3& across : g.acrossPath)
        rows.add(alongDirection(across, g.armToB, g.armB), across.dot(g.fromPath));
}

inline void addPathCoordinate(const JointGeometry& g, JointRows& coordinates) {
    coordinates.add(alongDirection(g.alongPath, g.armToB, g.armB),
                    g.wayOnPath + g.alongPath.dot(g.fromPath));
}

}  // namespace engine
