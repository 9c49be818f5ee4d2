// Soft rows are implicit-Euler springs; point joints are solved as a block. (mission 32)
#include "engine/constraints/soft.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

struct Oscillator {
    World world;
    BodyId mass;
};

/// 3 kg on a soft rod along x, stretched by `stretch`.
Oscillator oscillator(const Spring& spring, double stretch, const Settings& settings) {
    Oscillator o{World(settings), {}};
    o.world.setGravity(Vec3::Zero());
    const BodyId hook = o.world.add(support::hook());
    o.mass = o.world.add(support::body(Shape::sphere(0.1), {1.0 + stretch, 0, 0}, 3.0));
    JointDef def;
    def.type = JointType::distance;
    def.a = hook, def.b = o.mass, def.length = 1.0, def.spring = spring;
    o.world.add(def);
    return o;
}

Settings oneSubstep(Method method) {
    Settings settings = Settings::seed();
    settings.method = method;
    return settings;
}

class SoftConstraint : public testing::TestWithParam<Method> {};

TEST_P(SoftConstraint, IsTheImplicitEulerSpring) {
    const double m = 3.0, hz = 2.0, zeta = 0.5, h = support::kStep;
    const double w = 2.0 * M_PI * hz, k = m * w * w, c = 2.0 * m * zeta * w;
    Oscillator o = oscillator({hz, zeta}, 0.3, oneSubstep(GetParam()));
    double x = 0.3, v = 0.0;
    for (int step = 0; step < 120; ++step) {
        // m (v1 - v0) = -h (k (x0 + h v1) + c v1)
        v = (v - h * k / m * x) / (1.0 + h * c / m + h * h * k / m);
        x += h * v;
        o.world.step(h);
        ASSERT_NEAR(o.world.pose(o.mass).position.x(), 1.0 + x, 1e-12) << step;
        ASSERT_NEAR(o.world.velocity(o.mass).x(), v, 1e-12) << step;
    }
}
INSTANTIATE_TEST_SUITE_P(Methods, SoftConstraint,
                         testing::Values(Method::impulses, Method::pgs, Method::pgsMatrix,
                                         Method::direct));

TEST(SoftConstraint, TakesAStiffnessAndAResistanceOfItsOwn) {
    // k and c that match the frequency and damping ratio give the same motion
    const double m = 3.0, w = 2.0 * M_PI * 2.0;
    Spring own;
    own.stiffness = m * w * w, own.resistance = 2.0 * m * 0.5 * w;
    Oscillator a = oscillator({2.0, 0.5}, 0.3, Settings::steady());
    Oscillator b = oscillator(own, 0.3, Settings::steady());
    EXPECT_NEAR(b.world.energy().elastic, 0.5 * own.stiffness * 0.3 * 0.3, 1e-9);
    support::run(a.world, 60);
    support::run(b.world, 60);
    EXPECT_NEAR(a.world.pose(a.mass).position.x(), b.world.pose(b.mass).position.x(), 1e-9);
    EXPECT_TRUE(own.isSoft());
    EXPECT_FALSE(Spring{}.isSoft());
}

TEST(SoftConstraint, SagsByGOverOmegaSquared) {
    Oscillator o = oscillator({2.0, 1.0}, 0.0, Settings::steady());
    o.world.setGravity({9.81, 0, 0});
    support::run(o.world, 600);
    const double w = 2.0 * M_PI * 2.0;
    EXPECT_NEAR(o.world.pose(o.mass).position.x() - 1.0, 9.81 / (w * w), 1e-6);
}

TEST(SoftConstraint, EnergyCountsTheSpring) {
    Oscillator o = oscillator({2.0, 0.0}, 0.3, Settings::steady());
    const double w = 2.0 * M_PI * 2.0;
    const double stored = 0.5 * 3.0 * w * w * 0.3 * 0.3;
    EXPECT_NEAR(o.world.energy().elastic, stored, 1e-9);
    double most = 0.0;
    for (int i = 0; i < 60; ++i) {
        o.world.step(support::kStep);
        most = larger(most, o.world.energy().total());
    }
    EXPECT_LE(most, stored * 1.002);
    EXPECT_GT(o.world.energy().total(), 0.998 * stored);
}

TEST(SoftConstraint, AnyStiffnessIsStable) {
    for (const double hz : {1.0, 60.0, 1000.0}) {
        Oscillator o = oscillator({hz, 0.0}, 0.3, Settings::steady());
        support::run(o.world, 300);
        EXPECT_LE(std::abs(o.world.pose(o.mass).position.x() - 1.0), 0.302) << hz;
    }
}

/// The largest stretch in the last `seconds` of `all` seconds; it begins with 0.3 m.
double amplitude(const Spring& spring, const Settings& settings, double all, double seconds) {
    Oscillator o = oscillator(spring, 0.3, settings);
    double largest = 0.0;
    for (int i = 0; i < all * 60.0; ++i) {
        o.world.step(support::kStep);
        if (i < (all - seconds) * 60.0) continue;
        largest = larger(largest, std::abs(o.world.pose(o.mass).position.x() - 1.0));
    }
    return largest / 0.3;
}

// From 0.1 Hz to a twentieth of the step rate.
TEST(SoftConstraint, SwingsAHundredTimesWithoutDamping) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double hz : {0.1, 0.7, 1.5, 3.0})
            EXPECT_NEAR(amplitude({hz, 0.0}, settings, 100.0 / hz, 20.0 / hz), 1.0, 0.01) << hz;
}

// The peak after n periods of the damped swing is e^(-zeta w t).
TEST(SoftConstraint, DecaysAsZetaOmegaT) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double hz : {0.3, 1.0, 3.0})
            for (const double zeta : {0.01, 0.1, 0.3, 0.5}) {
                const double w = 2.0 * M_PI * hz, damped = w * std::sqrt(1.0 - zeta * zeta);
                const double period = 2.0 * M_PI / damped, end = 2.1 * period;
                const double peak = amplitude({hz, zeta}, settings, end, 0.2 * period);
                EXPECT_NEAR(peak / std::exp(-zeta * w * 2.0 * period), 1.0, 0.02)
                    << hz << ' ' << zeta;
            }
}

TEST(SoftConstraint, StaysBoundedAtAnyStiffness) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (double hz = 3.0; hz < 1e6; hz *= 2.3)
            for (const double zeta : {0.0, 0.1, 1.0, 20.0})
                EXPECT_LE(amplitude({hz, zeta}, settings, 2.0, 2.0), 1.01) << hz << ' ' << zeta;
}

/// A point joint's three rows solved together satisfy J v = 0 in one sweep; row by row they do not.
TEST(PointBlock, MeetsAPointInOneSweep) {
    const auto residualOfSecondSweep = [](bool block) {
        Settings settings = Settings::seed();
        settings.block = block;
        settings.sweeps = settings.minSweeps = 2;
        World world(settings);
        const BodyId hook = world.add(support::hook());
        const BodyId box = world.add(support::body(Shape::box({0.2, 1.0, 0.6}), {0.4, -0.5, 0.2}));
        support::join(world, JointType::ball, hook, box, {0, 0, 0});
        world.step(support::kStep);
        return world.report().sweeps.at(1).residual;
    };
    EXPECT_LT(residualOfSecondSweep(true), 1e-15);
    EXPECT_GT(residualOfSecondSweep(false), 1e-4);
}

TEST(PointBlock, HoldsAClosedLoop) {
    Settings settings = Settings::steady();
    settings.joints = JointSolving::rows;
    World world(settings);
    const BodyId hook = world.add(support::hook());
    BodyId last = hook;
    for (int i = 0; i < 4; ++i) {
        const BodyId next = world.add(support::body(Shape::box({0.8, 0.1, 0.1}), {i + 0.5, 0, 0}));
        support::join(world, JointType::ball, last, next, {1.0 * i, 0, 0});
        last = next;
    }
    support::join(world, JointType::ball, last, hook, {4, 0, 0});
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
        world.step(support::kStep);
        worst = larger(worst, world.errors().separation);
    }
    EXPECT_LT(worst, 2e-3);
}

}  // namespace
}  // namespace engine
