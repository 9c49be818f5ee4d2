/// Constant velocity joint (homokinetic): a common point, and a rotation from the straight joint that is only
/// swing, with no twist about the shafts. Both shafts turn at the same rate at every angle between them: for
/// C = 0, the rate below is along the line that bisects that angle.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = 2 u.h, zero with the twist about a's shaft (turning.h),   J = [0, -rate, 0, rate],   rate = s h - h x u
/// The twist itself is undefined after a swing by half a turn, and passing there took energy away.
/// q_0 is that of the straight joint, whatever the angle when the joint was made. The swing is free.
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

inline void addConstantVelocityRows(const JointGeometry& g, JointRows& rows) {
    addBallRows(g, rows);
    addTurn(heldTwist(g.axisA, turnSinceStart(g)), rows);
}

/// Coordinate 0 would be the twist, which is held.
inline void addConstantVelocityCoordinates(const JointGeometry& g, JointRows& coordinates) {
    coordinates.add({}, 0.0);
    addTurn(swingOf(g.axisA, g.axis2B), coordinates);
}

}  // namespace engine
