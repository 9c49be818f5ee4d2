/// Six degrees of freedom, each free or locked: three translations along x, y, z of a frame fixed
/// in a, and three rotations about them.
///   translation  C = e.d          as in a slider
///   rotation     x = phi, the twist about e (turning.h),   J = [0, -rate, 0, rate]
///                C = 2 u.e if it is locked: zero with the twist, and defined at any swing
/// The three twists form the rotation vector as long as at most one of them is large.
#pragma once
#include "engine/constraints/slider_joint.h"

namespace engine {

inline Vec3 sixDofAxis(const JointGeometry& g, int coordinate) {
    const Vec3 frame[3] = {g.axisA, g.axis2A, g.axisA.cross(g.axis2A)};
    return frame[coordinate % 3];
}

inline void addSixDofRows(const JointGeometry& g, JointRows& rows) {
    for (int i = 0; i < 6; ++i) {
        if (!(g.locked >> i & 1u)) continue;
        const Vec3 e = sixDofAxis(g, i);
        if (i < 3)
            rows.add(alongFixedInA(e, g), e.dot(g.between));
        else
            addTurn(heldTwist(e, turnSinceStart(g)), rows);
    }
}

inline void addSixDofCoordinates(const JointGeometry& g, JointRows& coordinates) {
    for (int i = 0; i < 6; ++i) {
        const Vec3 e = sixDofAxis(g, i);
        if (i < 3)
            coordinates.add(alongFixedInA(e, g), e.dot(g.between));
        else
            addTurn(twistAbout(e, turnSinceStart(g), g.near[i]), coordinates);
    }
}

}  // namespace engine
