/// Universal joint (Cardan): a point in common, and the two pins of its cross stay at right angles,
/// h_a fixed in a and k_b fixed in b.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = h_a.k_b,   dC/dt = (k_b x h_a).(w_b - w_a),   J = [0, -(k_b x h_a), 0, k_b x h_a]
/// Free are the angles about h_a, by which k_b has gone round it, and about k_b, by which the axis
/// that was h_a in b has gone round it (turning.h).
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

inline void addUniversalRows(const JointGeometry& g, JointRows& rows) {
    addBallRows(g, rows);
    const Vec3 turn = g.axis2B.cross(g.axisA);
    rows.add({Vec3::Zero(), Vec3(-turn), turn}, g.axisA.dot(g.axis2B));
}

inline void addUniversalCoordinates(const JointGeometry& g, JointRows& coordinates) {
    addTurn(turnAround(g.axis2A, g.axisA.cross(g.axis2A), g.axis2B, g.near[0]), coordinates);
    // a as seen from b goes round the other way, and w_a - w_b is the rate that counts there
    addTurn(turnAround(g.axisB, g.axisB.cross(g.axis2B), g.axisA, g.near[1]), coordinates, -1.0);
}

}  // namespace engine
