/// Constant velocity joint (homokinetic): a point in common, and of the turn from the straight joint
/// to how it is only swing, no twist about the shafts. What comes in on one goes out on the other,
/// at every angle between them: the rate below is, for C = 0, along the line that halves that angle.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = phi, the twist about a's shaft (turning.h),   J = [0, -rate, 0, rate]
/// q_0 is that of the straight joint, whatever the angle at which it was made. Free is the swing.
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

inline void addConstantVelocityRows(const JointGeometry& g, JointRows& rows) {
    addBallRows(g, rows);
    addTurn(twistAbout(g.axisA, turnSinceStart(g)), rows);
}

/// Coordinate 0 would be the twist, which is held.
inline void addConstantVelocityCoordinates(const JointGeometry& g, JointRows& coordinates) {
    coordinates.add({}, 0.0);
    addTurn(swingOf(g.axisA, g.axis2B), coordinates);
}

}  // namespace engine
