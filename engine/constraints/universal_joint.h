/// Universal joint (Cardan): a common point, and the two pins of its cross, h_a fixed in a and k_b
/// fixed in b, stay at right angles.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = h_a.k_b,   dC/dt = (k_b x h_a).(w_b - w_a),   J = [0, -(k_b x h_a), 0, k_b x h_a]
/// Two angles are free (turning.h): that of k_b about h_a, and about k_b that of the axis of b that
/// was h_a at the start.
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
    // Seen from b, a rotates the other way, with the rate w_a - w_b.
    addTurn(turnAround(g.axisB, g.axisB.cross(g.axis2B), g.axisA, g.near[1]), coordinates, -1.0);
}

}  // namespace engine
