/// Universal joint (Cardan): a point in common, and the two pins of its cross stay at right angles,
/// h_a fixed in a and k_b fixed in b.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = h_a.k_b,   dC/dt = (k_b x h_a).(w_b - w_a),   J = [0, -(k_b x h_a), 0, k_b x h_a]
/// Free are the angles about h_a, by which k_b has gone round it, and about k_b, by which the axis
/// that was h_a in b has gone round it (turning.h).
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

template <class Real>
void addUniversalRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    addBallRows(g, rows);
    const Vec3T<Real> turn = g.axis2B.cross(g.axisA);
    rows.add({Vec3T<Real>::Zero(), Vec3T<Real>(-turn), turn}, g.axisA.dot(g.axis2B));
}

template <class Real>
void addUniversalCoordinates(const JointGeometry<Real>& g, JointRows<Real>& coordinates) {
    addTurn(turnAround<Real>(g.axis2A, g.axisA.cross(g.axis2A), g.axis2B, g.near[0]),
            coordinates);
    // a as seen from b goes round the other way, and w_a - w_b is the rate that counts there
    addTurn(turnAround<Real>(g.axisB, g.axisB.cross(g.axis2B), g.axisA, g.near[1]), coordinates,
            Real(-1));
}

}  // namespace engine
