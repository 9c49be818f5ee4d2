// mission 1-3: integration against closed forms.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kGravity;
using support::kStep;
using support::run;

Settings oneSubstep() {
    Settings s = Settings::steady();
    s.substeps = s.maxSubsteps = 1;
    return s;
}

/// y after one second from rest, in n steps.
double fallIn(int steps, int substeps = 1) {
    Settings s = oneSubstep();
    s.substeps = s.maxSubsteps = substeps;
    World world(s);
    const BodyId ball = world.add(body(Shape::sphere(0.1), Vec3::Zero()));
    run(world, steps, 1.0 / steps);
    return world.pose(ball).position.y();
}

// y_n = -g dt^2 n (n + 1) / 2, the exact sum of v-then-x integration
TEST(FreeFall, FollowsTheSemiImplicitSum) {
    EXPECT_NEAR(fallIn(60), -4.98675, 1e-12);
    EXPECT_NEAR(fallIn(60), -kGravity * kStep * kStep * 60 * 61 / 2, 1e-12);
}

// mission 2: against dp = a t^2 / 2 the error is a t dt / 2, and halving dt halves it
TEST(FreeFall, ErrsByHalfAStep) {
    const double exact = -0.5 * kGravity;
    EXPECT_NEAR(fallIn(60) - exact, -kGravity * kStep / 2, 1e-12);
    EXPECT_NEAR((fallIn(60) - exact) / (fallIn(120) - exact), 2.0, 1e-9);
}

// mission 1: the exact parabola gives -4.905, explicit Euler -4.82325, as far on its other side
TEST(FreeFall, IsAsFarBelowTheParabolaAsExplicitEulerIsAbove) {
    double explicitEuler = 0.0, v = 0.0;
    for (int i = 0; i < 60; ++i) explicitEuler += v * kStep, v -= kGravity * kStep;
    EXPECT_NEAR(explicitEuler, -4.82325, 1e-12);
    EXPECT_NEAR(0.5 * (fallIn(60) + explicitEuler), -4.905, 1e-12);
}

TEST(FreeFall, SubstepsAreSteps) { EXPECT_NEAR(fallIn(60, 4), fallIn(240), 1e-12); }

TEST(FreeFlight, KeepsMomentumToTheBit) {
    World world;
    world.setGravity(Vec3::Zero());
    BodyDef ball = body(Shape::sphere(0.3), Vec3::Zero(), 2.0);
    ball.velocity = {1.1, -0.3, 0.7};
    ball.spin = {0.4, 0.5, 0.6};
    const BodyId id = world.add(ball);
    run(world, 600);
    EXPECT_EQ(world.velocity(id), ball.velocity);
    EXPECT_NEAR((world.pose(id).position - 10.0 * ball.velocity).norm(), 0.0, 1e-11);
    EXPECT_NEAR((world.spin(id) - ball.spin).norm(), 0.0, 1e-12);
}

TEST(AppliedForce, ActsForOneStepOnly) {
    World world;
    world.setGravity(Vec3::Zero());
    const BodyId id = world.add(body(Shape::sphere(0.3), Vec3::Zero(), 2.0));
    world.applyForce(id, {12, 0, 0});
    run(world, 2);
    EXPECT_NEAR(world.velocity(id).x(), 12 * kStep / 2.0, 1e-15);
}

// mission 3: forces may depend on rotation too. A torsion spring of 2 rad/s, compared with a
// formula: w -= k/I a h, then a += h w.
TEST(ForceField, MayDependOnRotation) {
    World world(oneSubstep());
    world.setGravity(Vec3::Zero());
    BodyDef wheel = body(Shape::sphere(0.5), Vec3::Zero(), 1.0);  // I = 2/5 m r^2 = 0.1
    wheel.pose.rotation = turnAbout(Vec3::UnitZ(), 0.3);
    const BodyId id = world.add(wheel);
    const auto angle = [id](const World& w) {
        const Quat& q = w.pose(id).rotation;
        return 2.0 * std::atan2(q.z(), q.w());
    };
    world.setForceField([&](const World& w, std::span<Load> loads) {
        loads[id.index].torque.z() -= 0.4 * angle(w);
    });
    double turned = 0.3, spin = 0.0;
    for (int i = 0; i < 600; ++i) {
        world.step(kStep);
        spin -= 4.0 * turned * kStep;
        turned += kStep * spin;
        ASSERT_NEAR(angle(world), turned, 1e-12) << i;
    }
}

}  // namespace
}  // namespace engine
