/// One row of a constraint between two bodies.
///   dC/dt = J v,   J = [-n, j_a, n, j_b],   v = [v_a, w_a, v_b, w_b]
/// n is the same for both bodies: a constraint between them feels their relative motion only.
///   K = J M^-1 J^T = (1/m_a + 1/m_b) n.n + j_a.(I_a^-1 j_a) + j_b.(I_b^-1 j_b)
/// is the inverse of the effective mass. An impulse lambda along the row changes the velocities by
///   dv = M^-1 J^T lambda.
/// (First seed, 'Calculating the constraint impulse', with the fourth block r_b x n and not r_a x n;
/// second seed, 'Constraints'.)
#pragma once
#include "engine/dynamics/bodies.h"

namespace engine {

template <class Real>
struct Jacobian {
    Vec3T<Real> linear = Vec3T<Real>::Zero();    // n
    Vec3T<Real> angularA = Vec3T<Real>::Zero();  // j_a
    Vec3T<Real> angularB = Vec3T<Real>::Zero();  // j_b
};

/// J of (p_b - p_a) . n, the relative motion along n of two points at the arms r_a and r_b:
///   J = [-n, -(r_a x n), n, r_b x n]
template <class Real>
Jacobian<Real> alongDirection(const Vec3T<Real>& n, const Vec3T<Real>& armA,
                              const Vec3T<Real>& armB) {
    return {n, Vec3T<Real>(-armA.cross(n)), Vec3T<Real>(armB.cross(n))};
}

/// J v
template <class Real>
Real velocityAlong(const Jacobian<Real>& j, const Velocity<Real>& a, const Velocity<Real>& b) {
    return j.linear.dot(b.linear - a.linear) + j.angularA.dot(a.angular) +
           j.angularB.dot(b.angular);
}

/// A row with what does not change while it is swept: M^-1 J^T and K.
template <class Real>
struct Row {
    Jacobian<Real> j;
    Real massA = Real(0), massB = Real(0);      // 1/kg
    Vec3T<Real> turnA = Vec3T<Real>::Zero();    // I_a^-1 j_a
    Vec3T<Real> turnB = Vec3T<Real>::Zero();    // I_b^-1 j_b
    Real k = Real(0);                           // J M^-1 J^T
};

/// J_i M^-1 J_j^T of two rows between the same two bodies.
template <class Real>
Real coupling(const Row<Real>& i, const Row<Real>& j) {
    return (i.massA + i.massB) * i.j.linear.dot(j.j.linear) + i.j.angularA.dot(j.turnA) +
           i.j.angularB.dot(j.turnB);
}

/// The part of J_i M^-1 J_k^T that goes through one body: i's b or a, and k's b or a.
template <class Real>
Real couplingThrough(const Row<Real>& i, bool ofB, const Row<Real>& k, bool toB) {
    const Real mass = ofB ? i.massB : i.massA;
    const Real sign = ofB == toB ? Real(1) : Real(-1);
    return sign * mass * i.j.linear.dot(k.j.linear) +
           (ofB ? i.j.angularB : i.j.angularA).dot(toB ? k.turnB : k.turnA);
}

template <class Real>
Row<Real> makeRow(const Jacobian<Real>& j, const InverseMass<Real>& a,
                  const InverseMass<Real>& b) {
    Row<Real> row{j, a.linear, b.linear, a.angular * j.angularA, b.angular * j.angularB, Real(0)};
    row.k = coupling(row, row);
    return row;
}

/// v += M^-1 J^T lambda
template <class Real>
void apply(const Row<Real>& row, Real lambda, Velocity<Real>& a, Velocity<Real>& b) {
    a.linear -= (row.massA * lambda) * row.j.linear;
    a.angular += lambda * row.turnA;
    b.linear += (row.massB * lambda) * row.j.linear;
    b.angular += lambda * row.turnB;
}

/// lambda = -(J v + b) / K: the impulse after which J v + b = 0. No mass, no impulse.
template <class Real>
Real correctiveImpulse(const Row<Real>& row, Real bias, const Velocity<Real>& a,
                       const Velocity<Real>& b) {
    return row.k > Real(0) ? -(velocityAlong(row.j, a, b) + bias) / row.k : Real(0);
}

}  // namespace engine
