/// One row of a constraint between two bodies.
///   dC/dt = J v,   J = [-n, j_a, n, j_b],   v = [v_a, w_a, v_b, w_b]
/// n is the same for both bodies: a constraint between them depends only on their relative motion.
///   K = J M^-1 J^T = (1/m_a + 1/m_b) n.n + j_a.(I_a^-1 j_a) + j_b.(I_b^-1 j_b)
/// is the inverse of the effective mass. An impulse lambda along the row changes the velocities by
///   dv = M^-1 J^T lambda.
/// (First seed, 'Calculating the constraint impulse', with the fourth block r_b x n and not r_a x n;
/// second seed, 'Constraints'.)
#pragma once
#include "engine/dynamics/bodies.h"

namespace engine {

struct Jacobian {
    Vec3 linear = Vec3::Zero();    // n
    Vec3 angularA = Vec3::Zero();  // j_a
    Vec3 angularB = Vec3::Zero();  // j_b
};

/// J of (p_b - p_a) . n, the relative motion along n of two points at the arms r_a and r_b:
///   J = [-n, -(r_a x n), n, r_b x n]
inline Jacobian alongDirection(const Vec3& n, const Vec3& armA, const Vec3& armB) {
    return {n, Vec3(-armA.cross(n)), Vec3(armB.cross(n))};
}

/// J v
inline double velocityAlong(const Jacobian& j, const Velocity& a, const Velocity& b) {
    return j.linear.dot(b.linear - a.linear) + j.angularA.dot(a.angular) +
           j.angularB.dot(b.angular);
}

/// A row with the values that stay constant during sweeps: M^-1 J^T and K.
struct Row {
    Jacobian j;
    double massA = 0.0, massB = 0.0;  // 1/kg
    Vec3 turnA = Vec3::Zero();        // I_a^-1 j_a
    Vec3 turnB = Vec3::Zero();        // I_b^-1 j_b
    double k = 0.0;                   // J M^-1 J^T
};

/// J_i M^-1 J_j^T of two rows between the same two bodies.
inline double coupling(const Row& i, const Row& j) {
    return (i.massA + i.massB) * i.j.linear.dot(j.j.linear) + i.j.angularA.dot(j.turnA) +
           i.j.angularB.dot(j.turnB);
}

/// The contribution of one body to J_i M^-1 J_k^T; it is b or a of row i, and b or a of row k.
inline double couplingThrough(const Row& i, bool ofB, const Row& k, bool toB) {
    const double mass = ofB ? i.massB : i.massA;
    const double sign = ofB == toB ? 1.0 : -1.0;
    return sign * mass * i.j.linear.dot(k.j.linear) +
           (ofB ? i.j.angularB : i.j.angularA).dot(toB ? k.turnB : k.turnA);
}

inline Row makeRow(const Jacobian& j, const InverseMass& a, const InverseMass& b) {
    Row row{j, a.linear, b.linear, a.angular * j.angularA, b.angular * j.angularB, 0.0};
    row.k = coupling(row, row);
    return row;
}

/// v += M^-1 J^T lambda
inline void apply(const Row& row, double lambda, Velocity& a, Velocity& b) {
    a.linear -= (row.massA * lambda) * row.j.linear;
    a.angular += lambda * row.turnA;
    b.linear += (row.massB * lambda) * row.j.linear;
    b.angular += lambda * row.turnB;
}

/// lambda = -(J v + b) / K: the impulse after which J v + b = 0; zero if neither body can move.
inline double correctiveImpulse(const Row& row, double bias, const Velocity& a, const Velocity& b) {
    return row.k > 0.0 ? -(velocityAlong(row.j, a, b) + bias) / row.k : 0.0;
}

}  // namespace engine
