/// Contact: two points that must not pass each other, with friction.
///   C = (p_b - p_a) . n >= 0          n from a to b, p on the two surfaces
///   J = [-n, -(r_a x n), n, r_b x n]  lambda in [0, inf)
/// The complete derivative has another term (p_b - p_a) . dn/dt, of the order of the gap; it is zero here,
/// because the normal is constant during a step.
/// Friction acts along two tangents t1, t2 with the same arms; its accumulated impulse is limited to the cone
///   |lambda_t| <= mu lambda_n
/// point by point (cone.h), or for the manifold as a whole where its normals are solved together
/// (manifold_friction.h).
/// (First seed, 'Constraint function' and 'The algorithm'; Catto, GDC 2006 and 2009.)
#pragma once
#include <array>

#include "engine/constraints/cone.h"
#include "engine/constraints/contact.h"
#include "engine/constraints/manifold_friction.h"
#include "engine/constraints/normal_block.h"

namespace engine {

/// One point. It is small on purpose: J and M^-1 J^T follow from the arms and the two masses by a few
/// products, which is cheaper than loading three rows of 144 bytes.
struct ContactRow {
    Vec3 armA = Vec3::Zero(), armB = Vec3::Zero();  // m, to the point
    ConeMass frictionMass;                          // along t1 and t2
    double bias = 0.0;                              // b in J v + b >= 0, m/s
    double lambda = 0.0;                            // N s, accumulated along n
    Vec2 friction = Vec2::Zero();                   // N s, accumulated along t1, t2
    double bounce = 0.0;                            // N s, from the impact pass of this sub-step
    double gapAtStart = 0.0;                        // C when the rows were made, m
    double separation = 0.0;                        // C now, m
    double total = 0.0;                             // N s along n, over the whole step
    Vec2 totalFriction = Vec2::Zero();              // N s, over the whole step
};

struct ContactConstraint {
    int a = -1, b = -1;
    int count = 0;
    int stride = 1;            // its bodies advance by this many of the world's sub-steps; 0: they wait
    double friction = 0.0;     // mu
    double restitution = 0.0;  // e
    double rolling = 0.0;      // rho, m
    Vec3 n = Vec3::Zero(), t1 = Vec3::Zero(), t2 = Vec3::Zero();
    Vec2 lead = Vec2::Zero();  // m/s along t1, t2: the slip that friction leaves (riding_contacts.h)
    InverseMass massA, massB;
    NormalBlock block;
    ManifoldFriction manifold;
    std::array<ContactRow, Contact::kMaxPoints> rows;
    ConeMass rollingMass;               // for rotation about t1 and t2
    Vec2 rollingMoment = Vec2::Zero();  // N m s on b, accumulated about t1, t2
};

/// Where a contact's points are, in world axes relative to the bodies' centres of mass.
struct ContactGeometry {
    Vec3 armA, armB;    // m, to the middle between the surfaces: a common point, so that two opposite
                        // impulses do not change the angular momentum
    double separation;  // C, m
};

/// The row of a point along one of the directions n, t1, t2.
inline Row rowAlong(const ContactConstraint& c, int i, const Vec3& direction) {
    return makeRow(alongDirection(direction, c.rows[i].armA, c.rows[i].armB), c.massA, c.massB);
}

/// The velocity of the point of b relative to that of a, m/s.
inline Vec3 velocityBetween(const ContactRow& row, const Velocity& a, const Velocity& b) {
    return (b.linear + b.angular.cross(row.armB)) - (a.linear + a.angular.cross(row.armA));
}

/// Applies the impulse P (N s) to b and -P to a, with the angular impulses about their centres.
inline void applyImpulse(const ContactConstraint& c, const Vec3& impulse, const Vec3& angularA,
                         const Vec3& angularB, Velocity& a, Velocity& b) {
    a.linear -= c.massA.linear * impulse;
    a.angular -= c.massA.angular * angularA;
    b.linear += c.massB.linear * impulse;
    b.angular += c.massB.angular * angularB;
}

/// The accumulated impulse of a point along n, t1 and t2.
inline Vec3 impulseOf(const ContactConstraint& c, const ContactRow& row) {
    return row.lambda * c.n + row.friction[0] * c.t1 + row.friction[1] * c.t2;
}

/// Applies an impulse at one point.
inline void applyAt(const ContactConstraint& c, const ContactRow& row, const Vec3& impulse,
                    Velocity& a, Velocity& b) {
    applyImpulse(c, impulse, row.armA.cross(impulse), row.armB.cross(impulse), a, b);
}

/// The row of the rotation of b relative to a about a direction; see constraints/rolling.h.
inline Row rowOfTurn(const ContactConstraint& c, const Vec3& direction) {
    return makeRow({Vec3(Vec3::Zero()), Vec3(-direction), direction}, c.massA, c.massB);
}

/// Computes the effective masses and the block from the rows' arms.
inline void setMasses(ContactConstraint& c, const InverseMass& massA, const InverseMass& massB) {
    c.massA = massA, c.massB = massB;
    Row normals[Contact::kMaxPoints];
    Vec3 armsA[Contact::kMaxPoints], armsB[Contact::kMaxPoints];
    for (int i = 0; i < c.count; ++i) {
        ContactRow& row = c.rows[i];
        normals[i] = rowAlong(c, i, c.n);
        row.frictionMass = coneMass(rowAlong(c, i, c.t1), rowAlong(c, i, c.t2));
        armsA[i] = row.armA, armsB[i] = row.armB;
    }
    c.manifold = manifoldFriction(c.n, c.t1, c.t2, c.count, armsA, armsB, massA, massB);
    c.block = makeNormalBlock(c.count, [&](int i) -> const Row& { return normals[i]; });
    if (c.rolling > 0.0) c.rollingMass = coneMass(rowOfTurn(c, c.t1), rowOfTurn(c, c.t2));
}

/// Sets arms, effective masses and the block of one contact. `points` may be hand-written: the solver does
/// not depend on where its constraints come from.
inline ContactConstraint makeContactConstraint(const Contact& contact,
                                               const ContactGeometry* points,
                                               const InverseMass& massA, const InverseMass& massB) {
    ContactConstraint c;
    c.a = contact.a, c.b = contact.b, c.count = contact.count;
    c.friction = contact.friction;
    c.restitution = contact.restitution;
    c.rolling = contact.rolling;
    c.n = contact.normal;
    tangents(c.n, c.t1, c.t2);
    for (int i = 0; i < c.count; ++i) {
        ContactRow& row = c.rows[i];
        row.armA = points[i].armA, row.armB = points[i].armB;
        row.gapAtStart = row.separation = points[i].separation;
        row.lambda = contact.points[i].impulse;
        const Vec3 friction = contact.points[i].friction;
        row.friction << friction.dot(c.t1), friction.dot(c.t2);
    }
    if (c.rolling > 0.0)
        c.rollingMoment << contact.rollingMoment.dot(c.t1), contact.rollingMoment.dot(c.t2);
    setMasses(c, massA, massB);
    return c;
}

/// The largest |change of velocity along a row| and the sum of |change of lambda| of one solve.
struct Correction {
    double velocity = 0.0;
    double impulse = 0.0;

    void add(double dv, double dLambda) {
        velocity = larger(velocity, std::abs(dv));
        impulse += std::abs(dLambda);
    }
    /// For two rows in a cone: an upper bound of the slip that their change causes.
    void add(const ConeMass& mass, const Vec2& change) {
        const double most = larger(std::abs(change[0]), std::abs(change[1]));
        if (mass.slide > 0.0) velocity = larger(velocity, most / mass.slide);
        impulse += std::abs(change[0]) + std::abs(change[1]);
    }
};

/// lambda may only push. The sum over all sweeps is clamped, not the change in this sweep. (First seed,
/// 'Global solution'.) accumulate = false shows what happens otherwise.
inline double pushOnly(double& accumulated, double lambda, bool accumulate) {
    const double before = accumulated;
    accumulated = accumulate ? larger(before + lambda, 0.0) : before + larger(lambda, 0.0);
    return accumulated - before;
}

/// Solves the normal rows one after the other.
inline void solveNormals(ContactConstraint& c, bool accumulate, Velocity& a, Velocity& b,
                         Correction& correction) {
    for (int i = 0; i < c.count; ++i) {
        ContactRow& row = c.rows[i];
        const double k = c.block.exact[i];
        if (k <= 0.0) continue;
        const double lambda = -(c.n.dot(velocityBetween(row, a, b)) + row.bias) / k;
        const double change = pushOnly(row.lambda, lambda, accumulate);
        applyAt(c, row, change * c.n, a, b);
        correction.add(k * change, change);
    }
}

/// Solves all normal rows of the manifold at once.
inline void solveNormalsTogether(ContactConstraint& c, Velocity& a, Velocity& b,
                                 Correction& correction) {
    Vec4 before = Vec4::Zero(), q = Vec4::Zero();
    for (int i = 0; i < c.count; ++i) {
        before[i] = c.rows[i].lambda;
        q[i] = c.n.dot(velocityBetween(c.rows[i], a, b)) + c.rows[i].bias;
    }
    const Vec4 lambda = solveNormalBlock(c.block, Vec4(q - c.block.k * before));
    const Vec4 change = lambda - before;
    const Vec4 dv = c.block.k * change;
    double sum = 0.0;
    Vec3 leverA = Vec3::Zero(), leverB = Vec3::Zero();
    for (int i = 0; i < c.count; ++i) {
        c.rows[i].lambda = lambda[i];
        sum += change[i];
        leverA += change[i] * c.rows[i].armA;
        leverB += change[i] * c.rows[i].armB;
        correction.add(dv[i], change[i]);
    }
    applyImpulse(c, sum * c.n, leverA.cross(c.n), leverB.cross(c.n), a, b);
}

inline void solveFriction(ContactConstraint& c, Velocity& a, Velocity& b, Correction& correction) {
    for (int i = 0; i < c.count; ++i) {
        ContactRow& row = c.rows[i];
        const Vec3 between = velocityBetween(row, a, b);
        const Vec2 slip(c.t1.dot(between) - c.lead[0], c.t2.dot(between) - c.lead[1]);
        const Vec2 before = row.friction;
        const double limit = c.friction * (row.lambda + row.bounce);
        row.friction = solveInCone(row.frictionMass, before, slip, limit);
        const Vec2 change = row.friction - before;
        applyAt(c, row, change[0] * c.t1 + change[1] * c.t2, a, b);
        correction.add(row.frictionMass, change);
    }
}

/// Solves the points of a slipping manifold (s_1, s_2, w_n) one after the other; returns their change (F_1,
/// F_2, T).
inline Vec3 slidePoints(ContactConstraint& c, Vec3 slip, const Vec4& limit, Correction& correction) {
    const ManifoldFriction& f = c.manifold;
    Vec3 change = Vec3::Zero();
    for (int i = 0; i < c.count; ++i) {
        ContactRow& row = c.rows[i];
        const Vec2 at(slip.x() - f.y[i] * slip.z(), slip.y() + f.x[i] * slip.z());
        const Vec2 after = solveInCone(row.frictionMass, row.friction, at, limit[i]);
        const Vec3 by = aboutMiddle(f, i, after - row.friction);
        correction.add(row.frictionMass, after - row.friction);
        row.friction = after;
        change += by;
        slip += f.k * by;
    }
    return change;
}

/// Solves friction of all points at once; see manifold_friction.h.
inline void solveFrictionTogether(ContactConstraint& c, Velocity& a, Velocity& b,
                                  Correction& correction) {
    if (c.friction <= 0.0) return;
    const ManifoldFriction& f = c.manifold;
    const Vec3 between =
        (b.linear + b.angular.cross(f.armB)) - (a.linear + a.angular.cross(f.armA));
    Vec3 slip(c.t1.dot(between) - c.lead[0], c.t2.dot(between) - c.lead[1],
              c.n.dot(b.angular - a.angular));
    Vec4 limit = Vec4::Zero();
    Vec3 total = Vec3::Zero(), change = Vec3::Zero();
    for (int i = 0; i < c.count; ++i) {
        limit[i] = c.friction * (c.rows[i].lambda + c.rows[i].bounce);
        total += aboutMiddle(f, i, c.rows[i].friction);
    }
    std::array<Vec2, Contact::kMaxPoints> shares;
    shares.fill(Vec2::Zero());
    const bool loaded = limit.sum() > 0.0;
    const Vec3 wanted = loaded ? Vec3(total - f.mass * slip) : Vec3(Vec3::Zero());
    if (!loaded || shareFriction(f, c.count, wanted, limit, shares)) {
        change = wanted - total;
        const double removed =
            larger(std::abs(slip.x()), std::abs(slip.y())) + f.reach * std::abs(slip.z());
        correction.add(loaded ? removed : 0.0, 0.0);
        for (int i = 0; i < c.count; ++i) {
            correction.impulse += (shares[i] - c.rows[i].friction).lpNorm<1>();
            c.rows[i].friction = shares[i];
        }
    } else {
        change = slidePoints(c, slip, limit, correction);
    }
    const Vec3 impulse = change.x() * c.t1 + change.y() * c.t2, twist = change.z() * c.n;
    applyImpulse(c, impulse, f.armA.cross(impulse) + twist, f.armB.cross(impulse) + twist, a, b);
}

}  // namespace engine
