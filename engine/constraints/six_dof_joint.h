/// Six degrees of freedom, each free or locked: three ways along x, y, z of a frame fixed in a, and
/// three turns about them.
///   way    C = e.d                as in a slider
///   turn   C = phi, the twist about e (turning.h),   J = [0, -rate, 0, rate]
/// The three twists are the rotation vector while no more than one of them is large.
#pragma once
#include "engine/constraints/slider_joint.h"

namespace engine {

template <class Real>
void addSixDofRow(const JointGeometry<Real>& g, int coordinate, Real near, JointRows<Real>& rows) {
    const Vec3T<Real> frame[3] = {g.axisA, g.axis2A, g.axisA.cross(g.axis2A)};
    const Vec3T<Real>& e = frame[coordinate % 3];
    if (coordinate < 3)
        rows.add(alongFixedInA<Real>(e, g), e.dot(g.between));
    else
        addTurn(twistAbout<Real>(e, turnSinceStart(g), near), rows);
}

template <class Real>
void addSixDofRows(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    for (int i = 0; i < 6; ++i)
        if (g.locked >> i & 1u) addSixDofRow<Real>(g, i, Real(0), rows);
}

template <class Real>
void addSixDofCoordinates(const JointGeometry<Real>& g, JointRows<Real>& coordinates) {
    for (int i = 0; i < 6; ++i) addSixDofRow<Real>(g, i, g.near[i], coordinates);
}

}  // namespace engine
