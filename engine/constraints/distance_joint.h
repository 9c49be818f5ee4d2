/// Distance joint (rod): keeps two points at the distance l.
///   C = |p_b - p_a| - l                                         one row
///   dC/dt = n.(dp_b/dt - dp_a/dt),   n = (p_b - p_a) / |p_b - p_a|
///   J = [-n, -(r_a x n), n, r_b x n]
/// The change of n is perpendicular to n and drops out. (Second seed, 'Constraints'.) If the two
/// points coincide there is no direction, and y is used. With a limit, motor or spring the distance
/// is free: an upper limit alone makes it a rope.
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

inline void addDistance(const JointGeometry& g, double length, JointRows& rows) {
    const double distance = g.between.norm();
    const Vec3 n = distance > 0.0 ? Vec3(g.between / distance) : Vec3(Vec3::UnitY());
    rows.add(alongDirection(n, g.armA, g.armB), distance - length);
}

inline void addDistanceRow(const JointGeometry& g, JointRows& rows) {
    addDistance(g, g.length, rows);
}

inline void addDistanceCoordinate(const JointGeometry& g, JointRows& coordinates) {
    addDistance(g, 0.0, coordinates);
}

}  // namespace engine
