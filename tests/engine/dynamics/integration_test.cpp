#include "engine/dynamics/integration.h"

#include <gtest/gtest.h>

#include "engine/dynamics/energy.h"
#include "engine/dynamics/forces.h"
#include "engine/dynamics/rotation.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

// mission 1: undamped oscillator, w = 2 rad/s, 60 000 steps: E / E0 in [0.9836, 1.0170]. The method
// keeps v^2 + w^2 x^2 - h w^2 x v, so the bounds are 1 / (1 +- h w / 2) = 60/61 and 60/59.
TEST(SemiImplicitEuler, KeepsAnOscillatorsEnergyBounded) {
    Bodies bodies;
    addBody(bodies, support::body(Shape::sphere(0.1), {1, 0, 0}, 1.0), bodies.count());
    setSpans(bodies, support::kStep);
    std::vector<Load> spring(1);
    double low = 1.0, high = 1.0;
    for (int i = 0; i < 60000; ++i) {
        spring[0].force = -4.0 * bodies.poses[0].position;  // k = m w^2
        applyForces(bodies, Vec3::Zero(), spring);
        integrateVelocities(bodies, Gyroscope::none);
        integratePositions(bodies, Gyroscope::none);
        const double e = energyOf(bodies, Vec3::Zero()).kinetic +
                         2.0 * bodies.poses[0].position.squaredNorm();
        low = smaller(low, e / 2.0), high = larger(high, e / 2.0);
    }
    EXPECT_GE(low, 0.9836);
    EXPECT_LE(high, 1.0170);
    EXPECT_NEAR(low, 60.0 / 61.0, 1e-6);
    EXPECT_NEAR(high, 60.0 / 59.0, 1e-6);
}

// The map keeps the angle to third order: tan(a / 2) = |turn| / 2.
TEST(Cayley, TurnsAboutTheVector) {
    const Quat q = cayley(Vec3(0, 0, 0.2), Quat::Identity());
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
    EXPECT_NEAR(2.0 * std::atan2(q.z(), q.w()), 2.0 * std::atan(0.1), 1e-15);
}

TEST(Momentum, IsKeptToTheLastBitsByTheFreeTurn) {
    Bodies bodies;
    BodyDef def = support::body(Shape::box({1, 2, 4}), Vec3::Zero());
    def.spin = {0.1, 5.0, 0.1};
    addBody(bodies, def, bodies.count());
    const Vec3 before = momentumOf(bodies).angular;
    setSpans(bodies, 1.0 / 240);
    for (int i = 0; i < 2400; ++i) integratePositions(bodies, Gyroscope::momentum);
    EXPECT_LT((momentumOf(bodies).angular - before).norm(), 1e-11 * before.norm());
}

/// The spin and rotation of a symmetric top after a time, by closed form and by the series of any other body.
TEST(SymmetricTop, TurnsAsTheSeriesOfABodyThatIsNearlyOne) {
    for (const Shape& shape : {Shape::capsule(0.05, 1.0), Shape::cylinder(1.0, 0.02),
                               Shape::box({0.05, 2.0, 0.05}), Shape::box({3.0, 0.1, 0.1})}) {
        BodyDef def = support::body(shape, Vec3::Zero(), 2.0);
        def.spin = {3.0, 15.0, -7.0};
        Bodies bodies;
        addBody(bodies, def, 0);
        def.inertia = bodies.masses[0].inertia;
        (*def.inertia)(0, 0) *= 1.0 + 1e-11;
        (*def.inertia)(1, 1) *= 1.0 - 1e-11;
        addBody(bodies, def, 1);
        ASSERT_GE(bodies.masses[0].topAxis, 0);
        ASSERT_LT(bodies.masses[1].topAxis, 0);
        setSpans(bodies, 1.0 / 60);
        for (int i = 0; i < 120; ++i) integratePositions(bodies, Gyroscope::momentum);
        EXPECT_LT(bodies.poses[0].rotation.angularDistance(bodies.poses[1].rotation), 1e-6);
        EXPECT_LT((bodies.velocities[0].angular - bodies.velocities[1].angular).norm(), 1e-6);
    }
}

// mission 9: M^-1 of immovable bodies is zero
TEST(InverseMass, OfAFixedOrKinematicBodyIsZero) {
    for (const BodyKind kind : {BodyKind::fixed, BodyKind::kinematic}) {
        BodyDef def = support::body(Shape::box({1, 2, 3}), Vec3::Zero(), 5.0);
        def.kind = kind;
        Bodies bodies;
        addBody(bodies, def, bodies.count());
        EXPECT_EQ(bodies.inverseMasses[0].linear, 0.0);
        EXPECT_TRUE(bodies.inverseMasses[0].angular.isZero(0.0));
    }
}

// Gravity does not rotate bodies, and forces do not affect fixed or kinematic bodies.
TEST(Forces, ActOnDynamicBodiesOnly) {
    Bodies bodies;
    addBody(bodies, support::body(Shape::sphere(0.5), Vec3::Zero(), 2.0), bodies.count());
    addBody(bodies, support::fixed(Shape::sphere(0.5)), bodies.count());
    BodyDef told = support::body(Shape::sphere(0.5), Vec3::Zero());
    told.kind = BodyKind::kinematic;
    told.velocity = {1, 0, 0};
    addBody(bodies, told, bodies.count());
    bodies.loads[0].force = {4, 0, 0};
    setSpans(bodies, 0.5);
    applyForces(bodies, {0, -10, 0}, {});
    integrateVelocities(bodies, Gyroscope::none);
    EXPECT_EQ(bodies.velocities[0].linear, Vec3(1, -5, 0));
    EXPECT_EQ(bodies.velocities[1].linear, Vec3(0, 0, 0));
    EXPECT_EQ(bodies.velocities[2].linear, Vec3(1, 0, 0));
}

// Two of a kind turn side by side, with the bits that each has alone: slow ones, and fast ones, whose angles
// need sines and whose series are cut.
TEST(FreeTurns, HaveTheBitsOfEveryBodyAlone) {
    const Shape shapes[] = {Shape::box({1, 1, 1}), Shape::capsule(0.2, 1.4), Shape::box({1, 2, 4})};
    Bodies bodies;
    for (int i = 0; i < 33; ++i) {  // an odd number of each kind: one is left over
        BodyDef def = support::body(shapes[i % 3], {3.0 * i, 0, 0});
        def.spin = Vec3(0.3 * i - 4.0, 1.7, 0.1 * i) * (i % 7 == 3 ? 40.0 : 1.0);
        def.pose.rotation = turnedBy(Vec3(0.2 * i, -1.0, 0.3), Quat::Identity());
        addBody(bodies, def, bodies.count());
        ASSERT_EQ(kindOfTurn(bodies.masses[i]), i % 3);
    }
    setSpans(bodies, support::kStep);
    const Bodies before = bodies;
    integratePositions(bodies, Gyroscope::momentum);
    for (int i = 0; i < bodies.count(); ++i) {
        Quat rotation = before.poses[i].rotation;
        Vec3 spin = before.velocities[i].angular;
        turnFreely(before.masses[i], Gyroscope::momentum, support::kStep, rotation, spin);
        EXPECT_EQ(bodies.poses[i].rotation.coeffs(), rotation.coeffs()) << i;
        EXPECT_EQ(bodies.velocities[i].angular, spin) << i;
    }
}

}  // namespace
}  // namespace engine
