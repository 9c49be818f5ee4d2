/// Hinge: a common point and a common axis.
///   C = p_b - p_a                                               three rows, as in a ball joint
///   C = t.h_b   for two t perpendicular to a's axis, fixed in a;  h_b is the axis fixed in b
///   dC/dt = (w_a x t).h_b + t.(w_b x h_b) = (t x h_b).(w_a - w_b)
///   J = [0, t x h_b, 0, -(t x h_b)]
/// The angle about the axis is free (turning.h); full turns are counted.
#pragma once
#include "engine/constraints/ball_joint.h"

namespace engine {

/// Keeps an axis of b parallel to the axis of a that both vectors of `across` are perpendicular to.
inline void addParallelRows(const Vec3 (&acrossA)[2], const Vec3& axisB, JointRows& rows) {
    for (const Vec3& across : acrossA) {
        const Vec3 turn = across.cross(axisB);
        rows.add({Vec3::Zero(), turn, Vec3(-turn)}, across.dot(axisB));
    }
}

inline void addHingeRows(const JointGeometry& g, JointRows& rows) {
    addBallRows(g, rows);
    addParallelRows(g.acrossA, g.axisB, rows);
}

inline void addHingeCoordinate(const JointGeometry& g, JointRows& coordinates) {
    addTurn(twistAbout(g.axisA, turnSinceStart(g), g.near[0]), coordinates);
}

}  // namespace engine
