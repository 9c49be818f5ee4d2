#include "engine/constraints/contact_constraint.h"

#include <gtest/gtest.h>

#include "engine/dynamics/rotation.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// A free body: pose and velocity, advanced by a time t to second order.
struct Moving {
    Pose pose;
    Velocity v;
    Pose after(double t) const {
        return {pose.position + t * v.linear, cayley(t * v.angular, pose.rotation)};
    }
};

Moving some(support::Random& random) {
    Moving m;
    m.pose = {random.vector(2), random.rotation()};
    m.v = {random.vector(2), random.vector(2)};
    return m;
}

// mission 13 with S1's full derivative: C = (p_b - p_a).n with n fixed in a; the second slot is then
// -((r_a + d) x n), d = p_b - p_a. On the surface (d along n) that is the -(r_a x n) of the engine.
TEST(Contact, TheVelocityIsTheDerivativeOfTheGap) {
    support::Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Moving a = some(random), b = some(random);
        const Vec3 anchorA = random.vector(1), anchorB = random.vector(1);
        const Vec3 nLocal = random.vector(1).normalized();
        const auto gap = [&](double t) {
            const Pose pa = a.after(t), pb = b.after(t);
            return (pb.toWorld(anchorB) - pa.toWorld(anchorA)).dot(pa.rotation * nLocal);
        };
        const Vec3 n = a.pose.rotation * nLocal;
        const Vec3 ra = a.pose.rotation * anchorA, rb = b.pose.rotation * anchorB;
        const Vec3 d = b.pose.position + rb - a.pose.position - ra;
        const Jacobian j = alongDirection(n, ra + d, rb);
        const double dt = 1e-5;
        const double slope = (gap(dt) - gap(-dt)) / (2 * dt);
        EXPECT_NEAR(velocityAlong(j, a.v, b.v), slope, 1e-6 * larger(1.0, std::abs(slope)));
    }
}

// mission 13: J = [-n, -(r_a x n), n, r_b x n]
TEST(Contact, HasTheFourBlocks) {
    const Vec3 n(0.6, 0.0, 0.8), ra(1, 2, 3), rb(-2, 1, 4);
    const Jacobian j = alongDirection(n, ra, rb);
    EXPECT_LT((j.angularA - -ra.cross(n)).norm(), 1e-15);
    EXPECT_LT((j.angularB - rb.cross(n)).norm(), 1e-15);
    const Velocity still;
    for (int i = 0; i < 3; ++i) {
        const Velocity one{Vec3::Unit(i), Vec3::Zero()};
        EXPECT_EQ(velocityAlong(j, one, still), -n[i]);
        EXPECT_EQ(velocityAlong(j, still, one), n[i]);
    }
}

// A gap along n changes nothing: (r_a + s n) x n = r_a x n. So the engine may end both arms midway between
// the surfaces.
TEST(Contact, AGapAlongTheNormalDropsOutOfTheFullDerivative) {
    support::Random random(2);
    for (int i = 0; i < 100; ++i) {
        const Vec3 n = random.vector(1).normalized(), ra = random.vector(1);
        const Jacobian printed = alongDirection(n, ra, Vec3::Zero());
        const Jacobian full = alongDirection(n, ra + random.number(-0.1, 0.1) * n, Vec3::Zero());
        EXPECT_LT((printed.angularA - full.angularA).norm(), 1e-15);
    }
}

ContactConstraint onePoint(double mu) {
    Contact contact;
    contact.a = 0, contact.b = 1, contact.count = 1;
    contact.friction = mu;
    const ContactGeometry point{Vec3::Zero(), Vec3::Zero(), 0.0};
    return makeContactConstraint(contact, &point, {}, {0.5, Mat3::Identity()});
}

// mission 18: lambda in [0, inf), and the total is clamped
TEST(Contact, OnlyPushesInTotal) {
    double total = 0.0;
    EXPECT_EQ(pushOnly(total, 2.0, true), 2.0);
    EXPECT_EQ(pushOnly(total, -0.5, true), -0.5);  // a correction may reduce it
    EXPECT_EQ(pushOnly(total, -5.0, true), -1.5);  // but not below zero
    EXPECT_EQ(total, 0.0);
}

// mission 33: |lambda_t| <= mu lambda_n, whatever the direction of the slip
TEST(Friction, IsACone) {
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double angle = degrees * 3.14159265358979 / 180;
        ContactConstraint c = onePoint(0.5);
        c.rows[0].lambda = 1.0;
        Velocity a, b;
        b.linear = Vec3(3 * std::cos(angle), 0, 3 * std::sin(angle));
        Correction correction;
        solveFriction(c, a, b, correction);
        EXPECT_NEAR(c.rows[0].friction.norm(), 0.5, 1e-14);
        EXPECT_NEAR(b.linear.norm(), 3.0 - 0.5 * 0.5, 1e-14);  // against the motion: mu lambda / m
        EXPECT_NEAR(b.linear.x() * std::sin(angle), b.linear.z() * std::cos(angle), 1e-14);
    }
}

TEST(Friction, StopsASlowSlipWithLessThanItsLimit) {
    ContactConstraint c = onePoint(0.5);
    c.rows[0].lambda = 1.0;
    Velocity a, b{{0.1, 0, 0.1}, Vec3::Zero()};
    Correction correction;
    solveFriction(c, a, b, correction);
    EXPECT_LT(b.linear.norm(), 1e-16);
    EXPECT_NEAR(c.rows[0].friction.norm(), 0.1 * std::sqrt(2.0) * 2.0, 1e-14);
}

}  // namespace
}  // namespace engine
