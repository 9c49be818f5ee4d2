// mission 34: pendulums against elliptic integrals and energy.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kGravity;
using support::kStep;

/// A small ball on a rod of 1 m, released at the angle from straight down.
struct Pendulum {
    World world;
    BodyId bob;
    JointId joint;

    explicit Pendulum(double degrees, const Settings& settings = Settings::steady())
        : world(settings) {
        const BodyId top = world.add(support::hook());
        const double a = radians(degrees);
        bob = world.add(body(Shape::sphere(0.05), {sine(a), -cosine(a), 0}));
        joint = support::rod(world, top, bob);
    }
    double x() const { return world.pose(bob).position.x(); }
};

/// Time between the first and the (2n + 1)th passage of x = 0, over n.
double period(Pendulum& p, int swings, double dt = kStep) {
    double first = -1.0, last = 0.0;
    int passages = 0;
    while (passages <= 2 * swings) {
        const double before = p.x(), t = p.world.report().time;
        p.world.step(dt);
        if ((before > 0) == (p.x() > 0)) continue;
        last = t + dt * before / (before - p.x());
        if (passages++ == 0) first = last;
    }
    return (last - first) / swings;
}

// T(90 deg, l = 1 m) = 4 sqrt(l / g) K(sin 45 deg) = 2.367842 s
TEST(Pendulum, SwingsInTheTimeOfTheEllipticIntegral) {
    Pendulum p(90);
    EXPECT_NEAR(period(p, 5), 2.367842, 0.003 * 2.367842);
}

// The error is proportional to the step, so two step lengths give the limit (Richardson), to the
// mission's digits.
TEST(Pendulum, TendsToTheEllipticIntegralWithTheStep) {
    Pendulum whole(90), half(90);
    const double t1 = period(whole, 5, 1.0 / 1920), t2 = period(half, 5, 1.0 / 3840);
    EXPECT_NEAR(t1, 2.367842, 5e-5);
    EXPECT_NEAR(2 * t2 - t1, 2.367842, 5e-7);
}

TEST(Pendulum, KeepsItsEnergyForAMinuteFromNearlyUpright) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        Pendulum p(170, settings);
        const double start = p.world.energy().total(), scale = kGravity * (1.0 - cosine(radians(170)));
        for (int i = 0; i < 3600; ++i) {
            p.world.step(kStep);
            ASSERT_NEAR((p.world.energy().total() - start) / scale, 0.0, 0.005) << i;
        }
    }
}

TEST(Pendulum, SwingsInTwoPiSqrtLOverGWhenSmall) {
    Pendulum p(2);
    EXPECT_NEAR(period(p, 5), 2 * kPi * std::sqrt(1 / kGravity), 0.003 * 2.0);
}

TEST(Pendulum, KeepsItsEnergyForAMinute) {
    Pendulum p(90);
    const double scale = kGravity;  // J: from the level to the bottom, 1 kg
    double low = 0.0, high = 0.0;
    for (int i = 0; i < 3600; ++i) {
        p.world.step(kStep);
        low = smaller(low, p.world.report().energy.total() / scale);
        high = larger(high, p.world.report().energy.total() / scale);
    }
    EXPECT_GT(low, -0.01);
    EXPECT_LT(high, 0.01);
    EXPECT_LT(p.world.joint(p.joint).separation, 1e-6);
}

// Joints as rows have no feedback of nudges, but follow the chord (solver/chords.h). Without either, two thirds of the
// energy are lost.
TEST(Pendulum, KeepsItsEnergyAsRows) {
    Settings rows = Settings::steady();
    rows.joints = JointSolving::rows;
    Pendulum p(90, rows);
    support::run(p.world, 3600);
    EXPECT_NEAR(p.world.report().energy.total() / kGravity, 0.0, 0.01);
}

/// N: largest pull in the rod over four seconds from the angle (deg).
double strongestPull(double degrees, double dt) {
    Pendulum p(degrees);
    double most = 0.0;
    for (int i = 0; i < static_cast<int>(4.0 / dt); ++i) {
        p.world.step(dt);
        most = larger(most, p.world.joint(p.joint).force.norm());
    }
    return most;
}

// rod tension at the bottom, released from theta0: m g (3 - 2 cos theta0)
TEST(Pendulum, PullsWithThreeGAtTheBottom) {
    for (const double degrees : {90.0, 60.0, 30.0}) {
        const double expected = kGravity * (3 - 2 * cosine(radians(degrees)));
        EXPECT_NEAR(strongestPull(degrees, kStep), expected, 1e-3 * expected) << degrees;
        EXPECT_NEAR(strongestPull(degrees, kStep / 16), expected, 1e-5 * expected) << degrees;
    }
}

TEST(Pendulum, OnAHingeStaysInItsPlane) {
    World world;
    const BodyId top = world.add(support::hook());
    const BodyId bar = world.add(body(Shape::box({1, 0.1, 0.3}), {0.5, 0, 0.0}));
    support::join(world, JointType::hinge, top, bar, Vec3::Zero(), Vec3::UnitZ());
    world.applyImpulse(bar, {0, 0, 3}, {1, 0, 0});
    double worst = 0.0;
    for (int i = 0; i < 600; ++i) {
        world.step(kStep);
        const Vec3 axis = world.pose(bar).rotation * Vec3::UnitZ();
        worst = larger(worst, (axis - Vec3::UnitZ()).norm());
        worst = larger(worst, std::abs(world.pose(bar).position.z()));
    }
    EXPECT_LT(worst, 2e-3);
}

}  // namespace
}  // namespace engine
