/// Ball joint: a point of a and a point of b coincide.
///   C = p_b - p_a = x_b + r_b - x_a - r_a                       three rows, along e = x, y, z
///   dC/dt = v_b + w_b x r_b - v_a - w_a x r_a
///   J_e = [-e, -(r_a x e), e, r_b x e]                          from e.(w x r) = w.(r x e)
/// The twist about its axis and the swing of the axis are free (turning.h); limiting them gives the
/// twist range and the cone of a shoulder.
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

inline void addBallRows(const JointGeometry& g, JointRows& rows) {
    for (int i = 0; i < 3; ++i)
        rows.add(alongDirection(Vec3::Unit(i), g.armA, g.armB), g.between[i]);
}

inline void addBallCoordinates(const JointGeometry& g, JointRows& coordinates) {
    addTurn(twistAbout(g.axisA, turnSinceStart(g), g.near[0]), coordinates);
    addTurn(swingOf(g.axisA, g.axis2B), coordinates);
}

}  // namespace engine
