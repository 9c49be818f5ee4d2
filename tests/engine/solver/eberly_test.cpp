// mission 17: Eberly's formula is the sequential impulse.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

struct Collision {
    InverseMass massA, massB;
    Vec3 ra, rb, n;
    Velocity a, b;
};

InverseMass boxMass(support::Random& random) {
    const double m = random.number(0.5, 20.0);
    const Vec3 edge = random.vector(0.7).cwiseAbs() + Vec3::Constant(0.2);
    const Vec3 s = edge.cwiseProduct(edge);
    const Vec3 inertia = m / 12 * Vec3(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
    const Mat3 r = random.rotation().toRotationMatrix();
    return {1.0 / m, r * inertia.cwiseInverse().asDiagonal() * r.transpose()};
}

Collision approaching(support::Random& random) {
    Collision c;
    for (;;) {
        c.massA = boxMass(random), c.massB = boxMass(random);
        c.ra = random.vector(0.7), c.rb = random.vector(0.7);
        c.n = random.vector(1).normalized();
        c.a = {random.vector(5), random.vector(5)}, c.b = {random.vector(5), random.vector(5)};
        if (velocityAlong(alongDirection(c.n, c.ra, c.rb), c.a, c.b) < -0.5) return c;
    }
}

/// -(1 + e) v_r.n / (1/m_a + 1/m_b + ((I_a^-1 (r_a x n)) x r_a + (I_b^-1 (r_b x n)) x r_b).n)
double eberly(const Collision& c, double e) {
    const Vec3 vr = c.b.linear + c.b.angular.cross(c.rb) - c.a.linear - c.a.angular.cross(c.ra);
    const Vec3 turn = (c.massA.angular * c.ra.cross(c.n)).cross(c.ra) +
                      (c.massB.angular * c.rb.cross(c.n)).cross(c.rb);
    return -(1.0 + e) * vr.dot(c.n) / (c.massA.linear + c.massB.linear + turn.dot(c.n));
}

TEST(Eberly, EqualsTheSequentialImpulse) {
    support::Random random(17);
    for (int i = 0; i < 1000; ++i) {
        const Collision c = approaching(random);
        const double e = i % 4 == 0 ? 0.0 : random.number(0.0, 1.0);
        Contact contact;
        contact.a = 0, contact.b = 1, contact.count = 1;
        contact.normal = c.n, contact.restitution = e;
        const ContactGeometry point{c.ra, c.rb, 0.0};
        Constraints constraints;
        constraints.contacts.push_back(makeContactConstraint(contact, &point, c.massA, c.massB));
        constraints.order = {0};
        std::vector<Velocity> v{c.a, c.b};
        std::vector<SweepReport> report;
        JointTrees trees;
        solveImpulses(constraints, trees, v, Settings::seed(), support::kStep, report);
        const double expected = eberly(c, e);
        EXPECT_NEAR(constraints.contacts[0].rows[0].lambda, expected, 1e-12 * expected);
        // mission 34: J v2 = -e J v1
        const Jacobian j = alongDirection(c.n, c.ra, c.rb);
        const double approach = velocityAlong(j, c.a, c.b);
        EXPECT_NEAR(velocityAlong(j, v[0], v[1]), -e * approach, 1e-12 * std::abs(approach));
    }
}

}  // namespace
}  // namespace engine
