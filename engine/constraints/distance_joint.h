/// Distance joint (rod): two points at the distance l.
///   C = |p_b - p_a| - l                                         one row
///   dC/dt = n.(dp_b/dt - dp_a/dt),   n = (p_b - p_a) / |p_b - p_a|
///   J = [-n, -(r_a x n), n, r_b x n]
/// The change of n itself is across n and drops out. (Second seed, 'Constraints'.) While the two
/// points coincide there is no direction, and y is as good as any.
/// Limited or driven, the distance is free: with an upper limit alone it is a rope.
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

template <class Real>
void addDistance(const JointGeometry<Real>& g, Real length, JointRows<Real>& rows) {
    const Real distance = g.between.norm();
    const Vec3T<Real> n = distance > Real(0) ? Vec3T<Real>(g.between / distance)
                                             : Vec3T<Real>(Vec3T<Real>::UnitY());
    rows.add(alongDirection(n, g.armA, g.armB), distance - length);
}

template <class Real>
void addDistanceRow(const JointGeometry<Real>& g, JointRows<Real>& rows) {
    addDistance(g, g.length, rows);
}

template <class Real>
void addDistanceCoordinate(const JointGeometry<Real>& g, JointRows<Real>& coordinates) {
    addDistance(g, Real(0), coordinates);
}

}  // namespace engine
