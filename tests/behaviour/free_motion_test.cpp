// mission 1-3: integration against closed forms.
#include <gtest/gtest.h>

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

// y_n = -g dt^2 n (n + 1) / 2, exactly what v-then-x integration adds up to
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

// mission 3: three bodies of unit mass that chase each other along a figure eight (Moore 1993;
// Chenciner and Montgomery 2000). Forces that depend on positions, asked for in every sub-step.
TEST(ThreeBodies, CloseTheFigureEight) {
    World world(oneSubstep());
    world.setGravity(Vec3::Zero());
    const Vec3 x1(0.97000436, -0.24308753, 0), v3(-0.93240737, -0.86473146, 0);
    const Vec3 x[3] = {x1, -x1, Vec3::Zero()}, v[3] = {-v3 / 2, -v3 / 2, v3};
    for (int i = 0; i < 3; ++i) {
        BodyDef star = body(Shape::sphere(0.01), x[i], 1.0);
        star.velocity = v[i];
        star.collide = false;
        world.add(star);
    }
    world.setForceField([](const World& w, std::span<Load> loads) {
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) {
                if (i == k) continue;
                const Vec3 d = w.pose({k}).position - w.pose({i}).position;
                loads[i].force += d / (d.squaredNorm() * d.norm());
            }
    });
    const double period = 6.32591398, dt = 1.0 / 240;
    const int steps = static_cast<int>(period / dt + 0.5);
    run(world, steps, period / steps);
    double closure = 0.0;
    for (int i = 0; i < 3; ++i) closure = larger(closure, (world.pose({i}).position - x[i]).norm());
    EXPECT_LT(closure, 0.010);  // mission 3: about 0.0085
    EXPECT_GT(closure, 0.001);
}

}  // namespace
}  // namespace engine
