/// Contact: two points that must not pass each other, and friction between them.
///   C = (p_b - p_a) . n >= 0          n from a to b, p on either surface
///   J = [-n, -(r_a x n), n, r_b x n]  lambda in [0, inf)
/// The complete derivative has a further term (p_b - p_a) . dn/dt, of the order of the gap; the normal
/// is held for one step, so it is zero here.
/// Friction acts along two tangents t1, t2 with the same arms; its impulse is held in the cone
///   |lambda_t| <= mu lambda_n
/// on accumulated values (cone.h).
/// (First seed, 'Constraint function' and 'The algorithm'; Catto, GDC 2006 and 2009.)
#pragma once
#include <array>

#include "engine/constraints/cone.h"
#include "engine/constraints/contact.h"
#include "engine/constraints/normal_block.h"

namespace engine {

/// One point. What the sweeps read of it is small on purpose: J and M^-1 J^T follow from the arms and
/// the two masses by a few products, which cost less than fetching three rows of 144 bytes.
template <class Real>
struct ContactRow {
    Vec3T<Real> armA = Vec3T<Real>::Zero(), armB = Vec3T<Real>::Zero();  // m, to the point
    ConeMass<Real> frictionMass;                       // along t1 and t2
    Real bias = Real(0);                               // b in J v + b >= 0, m/s
    Real lambda = Real(0);                             // N s, accumulated along n
    Vec2T<Real> friction = Vec2T<Real>::Zero();        // N s, accumulated along t1, t2
    Real bounce = Real(0);                             // N s, from the impact pass of this sub-step
    Real gapAtStart = Real(0);                         // C when the rows were made, m
    Real separation = Real(0);                         // C now, m
    Real total = Real(0);                              // N s along n, over the whole step
    Vec2T<Real> totalFriction = Vec2T<Real>::Zero();   // N s, over the whole step
};

template <class Real>
struct ContactConstraint {
    int a = -1, b = -1;
    int count = 0;
    Real friction = Real(0);     // mu
    Real restitution = Real(0);  // e
    Real rolling = Real(0);      // rho, m
    Vec3T<Real> n = Vec3T<Real>::Zero(), t1 = Vec3T<Real>::Zero(), t2 = Vec3T<Real>::Zero();
    InverseMass<Real> massA, massB;
    NormalBlock<Real> block;
    std::array<ContactRow<Real>, Contact::kMaxPoints> rows;
    ConeMass<Real> rollingMass;                         // of turns about t1 and t2
    Vec2T<Real> rollingMoment = Vec2T<Real>::Zero();    // N m s on b, accumulated about t1, t2
};

/// Where a contact's points are, in world axes relative to the bodies' centres of mass.
template <class Real>
struct ContactGeometry {
    Vec3T<Real> armA, armB;  // m, to the middle between the surfaces: one point, so that a pair of
                             // impulses changes no angular momentum
    Real separation;         // C, m
};

/// A point's row along one of the contact's directions n, t1, t2.
template <class Real>
Row<Real> rowAlong(const ContactConstraint<Real>& c, int i, const Vec3T<Real>& direction) {
    return makeRow(alongDirection(direction, c.rows[i].armA, c.rows[i].armB), c.massA, c.massB);
}

/// How fast the point of b leaves the point of a, m/s.
template <class Real>
Vec3T<Real> velocityBetween(const ContactRow<Real>& row, const Velocity<Real>& a,
                            const Velocity<Real>& b) {
    return (b.linear + b.angular.cross(row.armB)) - (a.linear + a.angular.cross(row.armA));
}

/// Applies the impulse P (N s) on b, -P on a, with the angular impulses about their centres.
template <class Real>
void applyImpulse(const ContactConstraint<Real>& c, const Vec3T<Real>& impulse,
                  const Vec3T<Real>& angularA, const Vec3T<Real>& angularB, Velocity<Real>& a,
                  Velocity<Real>& b) {
    a.linear -= c.massA.linear * impulse;
    a.angular -= c.massA.angular * angularA;
    b.linear += c.massB.linear * impulse;
    b.angular += c.massB.angular * angularB;
}

/// What a point has got so far, along n, t1 and t2 together.
template <class Real>
Vec3T<Real> impulseOf(const ContactConstraint<Real>& c, const ContactRow<Real>& row) {
    return row.lambda * c.n + row.friction[0] * c.t1 + row.friction[1] * c.t2;
}

/// At one point.
template <class Real>
void applyAt(const ContactConstraint<Real>& c, const ContactRow<Real>& row,
             const Vec3T<Real>& impulse, Velocity<Real>& a, Velocity<Real>& b) {
    applyImpulse<Real>(c, impulse, row.armA.cross(impulse), row.armB.cross(impulse), a, b);
}

/// The row of the turn of b over a about a direction; see constraints/rolling.h.
template <class Real>
Row<Real> rowOfTurn(const ContactConstraint<Real>& c, const Vec3T<Real>& direction) {
    return makeRow({Vec3T<Real>(Vec3T<Real>::Zero()), Vec3T<Real>(-direction), direction}, c.massA,
                   c.massB);
}

/// Arms, effective masses and the block of one contact. `points` may be written by hand: the solver
/// does not care where its constraints come from.
template <class Real>
ContactConstraint<Real> makeContactConstraint(const Contact& contact,
                                              const ContactGeometry<Real>* points,
                                              const InverseMass<Real>& massA,
                                              const InverseMass<Real>& massB) {
    ContactConstraint<Real> c;
    c.a = contact.a, c.b = contact.b, c.count = contact.count;
    c.massA = massA, c.massB = massB;
    c.friction = static_cast<Real>(contact.friction);
    c.restitution = static_cast<Real>(contact.restitution);
    c.rolling = static_cast<Real>(contact.rolling);
    c.n = contact.normal.template cast<Real>();
    tangents(c.n, c.t1, c.t2);
    Row<Real> normals[Contact::kMaxPoints];
    for (int i = 0; i < c.count; ++i) {
        ContactRow<Real>& row = c.rows[i];
        row.armA = points[i].armA, row.armB = points[i].armB;
        row.gapAtStart = row.separation = points[i].separation;
        normals[i] = rowAlong(c, i, c.n);
        row.frictionMass = coneMass(rowAlong(c, i, c.t1), rowAlong(c, i, c.t2));
        row.lambda = static_cast<Real>(contact.points[i].impulse);
        const Vec3T<Real> friction = contact.points[i].friction.template cast<Real>();
        row.friction << friction.dot(c.t1), friction.dot(c.t2);
    }
    c.block = makeNormalBlock<Real>(c.count,
                                    [&](int i) -> const Row<Real>& { return normals[i]; });
    if (c.rolling <= Real(0)) return c;
    c.rollingMass = coneMass(rowOfTurn(c, c.t1), rowOfTurn(c, c.t2));
    const Vec3T<Real> moment = contact.rollingMoment.template cast<Real>();
    c.rollingMoment << moment.dot(c.t1), moment.dot(c.t2);
    return c;
}

/// The largest |change of velocity along a row|, and sum of |change of lambda|, of one solve.
template <class Real>
struct Correction {
    Real velocity = Real(0);
    Real impulse = Real(0);

    void add(Real dv, Real dLambda) {
        velocity = larger(velocity, std::abs(dv));
        impulse += std::abs(dLambda);
    }
    /// Of two rows in a cone: the slip that their change makes, at most.
    void add(const ConeMass<Real>& mass, const Vec2T<Real>& change) {
        const Real most = larger(std::abs(change[0]), std::abs(change[1]));
        if (mass.slide > Real(0)) velocity = larger(velocity, most / mass.slide);
        impulse += std::abs(change[0]) + std::abs(change[1]);
    }
};

/// lambda may only push, and it is the sum over all sweeps that is clamped, not this sweep's share.
/// (First seed, 'Global solution'.) accumulate = false shows what happens otherwise.
template <class Real>
Real pushOnly(Real& accumulated, Real lambda, bool accumulate) {
    const Real before = accumulated;
    accumulated = accumulate ? larger(before + lambda, Real(0)) : before + larger(lambda, Real(0));
    return accumulated - before;
}

/// One normal row after the other.
template <class Real>
void solveNormals(ContactConstraint<Real>& c, bool accumulate, Velocity<Real>& a,
                  Velocity<Real>& b, Correction<Real>& correction) {
    for (int i = 0; i < c.count; ++i) {
        ContactRow<Real>& row = c.rows[i];
        const Real k = c.block.exact[i];
        if (k <= Real(0)) continue;
        const Real lambda = -(c.n.dot(velocityBetween(row, a, b)) + row.bias) / k;
        const Real change = pushOnly(row.lambda, lambda, accumulate);
        applyAt<Real>(c, row, change * c.n, a, b);
        correction.add(k * change, change);
    }
}

/// All normal rows of the manifold at once.
template <class Real>
void solveNormalsTogether(ContactConstraint<Real>& c, Velocity<Real>& a, Velocity<Real>& b,
                          Correction<Real>& correction) {
    Vec4T<Real> before = Vec4T<Real>::Zero(), q = Vec4T<Real>::Zero();
    for (int i = 0; i < c.count; ++i) {
        before[i] = c.rows[i].lambda;
        q[i] = c.n.dot(velocityBetween(c.rows[i], a, b)) + c.rows[i].bias;
    }
    const Vec4T<Real> lambda = solveNormalBlock(c.block, Vec4T<Real>(q - c.block.k * before));
    const Vec4T<Real> change = lambda - before;
    const Vec4T<Real> dv = c.block.k * change;
    Real sum = Real(0);
    Vec3T<Real> leverA = Vec3T<Real>::Zero(), leverB = Vec3T<Real>::Zero();
    for (int i = 0; i < c.count; ++i) {
        c.rows[i].lambda = lambda[i];
        sum += change[i];
        leverA += change[i] * c.rows[i].armA;
        leverB += change[i] * c.rows[i].armB;
        correction.add(dv[i], change[i]);
    }
    applyImpulse<Real>(c, sum * c.n, leverA.cross(c.n), leverB.cross(c.n), a, b);
}

template <class Real>
void solveFriction(ContactConstraint<Real>& c, Velocity<Real>& a, Velocity<Real>& b,
                   Correction<Real>& correction) {
    for (int i = 0; i < c.count; ++i) {
        ContactRow<Real>& row = c.rows[i];
        const Vec3T<Real> between = velocityBetween(row, a, b);
        const Vec2T<Real> slip(c.t1.dot(between), c.t2.dot(between));
        const Vec2T<Real> before = row.friction;
        const Real limit = c.friction * (row.lambda + row.bounce);
        row.friction = solveInCone(row.frictionMass, before, slip, limit);
        const Vec2T<Real> change = row.friction - before;
        applyAt<Real>(c, row, change[0] * c.t1 + change[1] * c.t2, a, b);
        correction.add(row.frictionMass, change);
    }
}

}  // namespace engine
