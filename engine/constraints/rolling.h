/// Rolling resistance: a moment against the rolling of one surface on the other. The load of a soft surface
/// acts at a distance rho ahead of the contact point, so its moment is rho times the load:
///   s = t . (w_b - w_a), for t1 and t2 across the normal     rad/s
///   J = [0, -t, 0, t]
///   |lambda| <= rho sum lambda_n                             N m s
/// A rolling ball comes to rest, and stays at rest on a slope with tan(angle) < rho / r. Friction handles the
/// rotation about the normal.
#pragma once
#include "engine/constraints/contact_constraint.h"

namespace engine {

/// The largest rolling moment of a contact, N m s.
inline double rollingLimit(const ContactConstraint& c) {
    double load = 0.0;
    for (int i = 0; i < c.count; ++i) load += c.rows[i].lambda + c.rows[i].bounce;
    return c.rolling * load;
}

/// Applies the angular impulse to b, and its opposite to a.
inline void applyRolling(const ContactConstraint& c, const Vec2& moment, Velocity& a, Velocity& b) {
    const Vec3 turn = moment[0] * c.t1 + moment[1] * c.t2;
    a.angular -= c.massA.angular * turn;
    b.angular += c.massB.angular * turn;
}

/// Applies all accumulated impulses of a contact.
inline void applyAll(const ContactConstraint& c, Velocity& a, Velocity& b) {
    for (int i = 0; i < c.count; ++i) applyAt(c, c.rows[i], impulseOf(c, c.rows[i]), a, b);
    if (c.rolling > 0.0) applyRolling(c, c.rollingMoment, a, b);
}

inline void solveRolling(ContactConstraint& c, Velocity& a, Velocity& b, Correction& correction) {
    if (c.rolling <= 0.0) return;
    const Vec3 turn = b.angular - a.angular;
    const Vec2 before = c.rollingMoment;
    c.rollingMoment =
        solveInCone(c.rollingMass, before, {c.t1.dot(turn), c.t2.dot(turn)}, rollingLimit(c));
    const Vec2 change = c.rollingMoment - before;
    applyRolling(c, change, a, b);
    correction.add(c.rollingMass, change);
}

}  // namespace engine
