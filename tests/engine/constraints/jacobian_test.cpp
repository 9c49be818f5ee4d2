#include "engine/constraints/jacobian.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/support/worlds.h"

namespace engine {
namespace {

InverseMass someMass(support::Random& random) {
    const double inverse = random.number(0.1, 2.0);
    const Mat3 r = random.rotation().toRotationMatrix();
    const Vec3 moments = random.vector(1).cwiseAbs() + Vec3::Constant(0.2);
    return {inverse, r * moments.asDiagonal() * r.transpose()};
}

// mission 5: m = 2, I = 0.4, r = (0, -0.5, 0), P = (1, 0, 0)
TEST(Impulse, ChangesVelocityAndSpin) {
    const InverseMass still, mass{1.0 / 2.0, Mat3::Identity() / 0.4};
    Velocity a, b;
    const Row row = makeRow(alongDirection({1, 0, 0}, Vec3::Zero(), {0, -0.5, 0}), still, mass);
    apply(row, 1.0, a, b);
    EXPECT_LT((b.linear - Vec3(0.5, 0, 0)).norm(), 1e-15);
    EXPECT_LT((b.angular - Vec3(0, 0, 1.25)).norm(), 1e-15);
    EXPECT_EQ(a.linear, Vec3::Zero());
}

// mission 5: a pair impulse leaves momentum and spin momentum unchanged
TEST(Impulse, OfAPairKeepsBothMomenta) {
    support::Random random(1);
    for (int i = 0; i < 100; ++i) {
        const InverseMass massA = someMass(random), massB = someMass(random);
        const Vec3 xa = random.vector(2), xb = random.vector(2), p = random.vector(2);
        const Vec3 n = random.vector(1).normalized();
        const Row row = makeRow(alongDirection(n, p - xa, p - xb), massA, massB);
        Velocity a, b;
        apply(row, random.number(-5, 5), a, b);
        const Vec3 pa = a.linear / massA.linear, pb = b.linear / massB.linear;
        const Mat3 ia = massA.angular.inverse(), ib = massB.angular.inverse();
        const Vec3 spin = xa.cross(pa) + ia * a.angular + xb.cross(pb) + ib * b.angular;
        EXPECT_LT((pa + pb).norm(), 1e-13);
        EXPECT_LT(spin.norm(), 2e-12);
    }
}

// mission 16: K = 1/m + (r x n).I^-1 (r x n), over both bodies
TEST(EffectiveMass, IsTheSumOverBothBodies) {
    support::Random random(2);
    const InverseMass a = someMass(random), b = someMass(random);
    const Vec3 ra = random.vector(1), rb = random.vector(1), n = random.vector(1).normalized();
    const Vec3 ta = ra.cross(n), tb = rb.cross(n);
    const double k = a.linear + b.linear + ta.dot(a.angular * ta) + tb.dot(b.angular * tb);
    EXPECT_NEAR(makeRow(alongDirection(n, ra, rb), a, b).k, k, 1e-14);
}

// mission 14 and 15: p = (3,4,0), p0 = 0, l = 4, v = (1,2,3), m = 2
TEST(CorrectiveImpulse, OfADistanceToAPoint) {
    const InverseMass still, mass{0.5, Mat3::Identity() / 0.4};
    Velocity a, b{{1, 2, 3}, Vec3::Zero()};
    const Vec3 n = Vec3(3, 4, 0) / 5.0;
    const Row row = makeRow(alongDirection(n, Vec3::Zero(), Vec3::Zero()), still, mass);
    EXPECT_NEAR(velocityAlong(row.j, a, b), 2.2, 1e-15);
    EXPECT_NEAR(row.k, 0.5, 1e-15);
    const double lambda = correctiveImpulse(row, 0.0, a, b);
    EXPECT_NEAR(lambda, -4.4, 1e-14);
    apply(row, lambda, a, b);
    EXPECT_LT((b.linear - Vec3(-0.32, 0.24, 3)).norm(), 1e-14);
    EXPECT_NEAR(velocityAlong(row.j, a, b), 0.0, 1e-15);
}

// mission 14: the same with the arm r = (0, -0.5, 0), I = 0.4, w = (0, 0, 1)
TEST(CorrectiveImpulse, OfADistanceAtAnArm) {
    const InverseMass still, mass{0.5, Mat3::Identity() / 0.4};
    Velocity a, b{{1, 2, 3}, {0, 0, 1}};
    const Vec3 n = Vec3(3, 4, 0) / 5.0;
    const Row row = makeRow(alongDirection(n, Vec3::Zero(), {0, -0.5, 0}), still, mass);
    EXPECT_NEAR(velocityAlong(row.j, a, b), 2.5, 1e-15);
    EXPECT_NEAR(row.k, 0.725, 1e-15);
    const double lambda = correctiveImpulse(row, 0.0, a, b);
    EXPECT_NEAR(lambda, -3.4482759, 5e-8);
    apply(row, lambda, a, b);
    EXPECT_LT((b.linear - Vec3(-0.0344828, 0.6206897, 3)).norm(), 1e-7);
    EXPECT_NEAR(b.angular.z(), -1.5862069, 5e-8);
}

TEST(CorrectiveImpulse, ReachesTheBias) {
    support::Random random(3);
    const InverseMass ma = someMass(random), mb = someMass(random);
    const Row row = makeRow(
        alongDirection(random.vector(1).normalized(), random.vector(1), random.vector(1)), ma, mb);
    Velocity a{random.vector(3), random.vector(3)}, b{random.vector(3), random.vector(3)};
    apply(row, correctiveImpulse(row, 0.7, a, b), a, b);
    EXPECT_NEAR(velocityAlong(row.j, a, b) + 0.7, 0.0, 1e-14);
}

TEST(CorrectiveImpulse, WithoutAnyMassIsNone) {
    const InverseMass still;
    const Row row = makeRow(alongDirection({0, 1, 0}, Vec3::Zero(), Vec3::Zero()), still, still);
    EXPECT_EQ(correctiveImpulse(row, 1.0, {}, {}), 0.0);
}

}  // namespace
}  // namespace engine
