/// Six degrees of freedom, each free or locked: three translations along x, y, z of a frame fixed
/// in a, and three rotations about them.
///   translation  C = e.d          as in a slider
///   rotation     C = phi, the twist about e (turning.h),   J = [0, -rate, 0, rate]
/// The three twists form the rotation vector as long as at most one of them is large.
#pragma once
#include "engine/constraints/slider_joint.h"

namespace engine {

inline void addSixDofRow(const JointGeometry& g, int coordinate, double near, JointRows& rows) {
    const Vec3 frame[3] = {g.axisA, g.axis2A, g.axisA.cross(g.axis2A)};
    const Vec3& e = frame[coordinate % 3];
    if (coordinate < 3)
        rows.add(alongFixedInA(e, g), e.dot(g.between));
    else
        addTurn(twistAbout(e, turnSinceStart(g), near), rows);
}

inline void addSixDofRows(const JointGeometry& g, JointRows& rows) {
    for (int i = 0; i < 6; ++i)
        if (g.locked >> i & 1u) addSixDofRow(g, i, 0.0, rows);
}

inline void addSixDofCoordinates(const JointGeometry& g, JointRows& coordinates) {
    for (int i = 0; i < 6; ++i) addSixDofRow(g, i, g.near[i], coordinates);
}

}  // namespace engine
