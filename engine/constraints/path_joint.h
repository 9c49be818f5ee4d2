/// Path: a point of b stays on a curve fixed in a (catmull_rom.h); b rotates freely.
///   C = t.d   for two t perpendicular to the curve at its nearest point;  d = p_b - p(s), d.p' = 0
///   dC/dt = t.(v_b + w_b x r_b - v_a - w_a x (r_b + x_b - x_a)) + t.(-p' ds/dt) + (dt/ds).d ds/dt
///   J = [-t, -((x_b + r_b - x_a) x t), t, r_b x t]
/// The second term is zero, the third is of the order of C. The distance along the curve, m from
/// its first point, is free; beyond an end the curve continues straight.
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
