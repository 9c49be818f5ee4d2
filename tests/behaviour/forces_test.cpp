// Forces besides gravity, compared with closed forms of the motion.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "engine/forces/airfoil.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::kGravity;

/// One body, one force, four sub-steps per step.
struct OneBody {
    World world;
    BodyId body;

    explicit OneBody(const BodyDef& def, const Vec3& gravity = Vec3::Zero()) {
        world.setGravity(gravity);
        body = world.add(def);
    }
    ForceId add(const ForceKind& kind) { return world.add(ForceDef{kind, {body}}); }
    const Vec3& velocity() const { return world.velocity(body); }
    const Vec3& position() const { return world.pose(body).position; }
};

BodyDef ball(double mass, const Vec3& at = Vec3::Zero()) {
    return support::body(Shape::sphere(0.5), at, mass);
}

const Vec3 kDown(0, -kGravity, 0);

// v_n = v_0 (1 - c h / m)^n, w_n = w_0 (1 - k h / I)^n
TEST(DragForce, DecaysByTheSameShareInEverySubstep) {
    BodyDef def = ball(2.0);
    def.velocity = {3, 0, 0}, def.spin = {0, 4, 0};
    OneBody flight(def);
    flight.add(Drag{0.8, 0.05});
    support::run(flight.world, 60);
    const double h = support::kStep / 4;
    double v = 3.0, w = 4.0;
    for (int i = 0; i < 240; ++i) v *= 1.0 - 0.8 * h / 2.0, w *= 1.0 - 0.05 * h / 0.2;
    EXPECT_NEAR(flight.velocity().x(), v, 1e-12);
    EXPECT_NEAR(flight.world.spin(flight.body).y(), w, 1e-12);
    EXPECT_NEAR(v, 3.0 * std::exp(-0.4), 2e-3);  // nearly e^(-c t / m)
}

TEST(DragForce, LetsAFallingBodyReachMGOverC) {
    OneBody flight(ball(2.0), kDown);
    flight.add(Drag{5.0, 0.0});
    support::run(flight.world, 600);
    EXPECT_NEAR(flight.velocity().y(), -2.0 * kGravity / 5.0, 1e-9);
}

TEST(DragForce, HoweverLargeStopsABodyAndNeverTurnsItRound) {
    BodyDef def = ball(1.0);
    def.velocity = {50, 0, 0}, def.spin = {0, 0, 30};
    OneBody flight(def);
    flight.add(Drag{1e6, 1e6});
    support::run(flight.world, 60);
    EXPECT_NEAR(flight.velocity().norm(), 0.0, 1e-12);
    EXPECT_NEAR(flight.world.spin(flight.body).norm(), 0.0, 1e-12);
}

// rho/2 C A v^2 = (m - rho V) g
TEST(MediumForce, LetsAFallingBallReachItsTerminalSpeed) {
    OneBody flight(ball(1.0), kDown);
    Medium air;
    air.density = 1.2, air.dragCoefficient = 0.47;
    flight.add(air);
    support::run(flight.world, 1200);
    const double volume = kPi / 6.0, area = kPi / 4.0;
    const double speed = std::sqrt(2 * (1.0 - 1.2 * volume) * kGravity / (1.2 * 0.47 * area));
    EXPECT_NEAR(flight.velocity().y(), -speed, 1e-6);
}

// v(t) = v_0 / (1 + v_0 t / l), l = 2 m / (rho C A): quadratic drag alone
TEST(MediumForce, BrakesWithTheSquareOfTheSpeed) {
    BodyDef def = ball(1.0);
    def.velocity = {20, 0, 0};
    OneBody flight(def);
    flight.add(Medium{.density = 1.2, .dragCoefficient = 1.0});
    support::run(flight.world, 120);
    const double length = 2.0 / (1.2 * kPi / 4.0);
    EXPECT_NEAR(flight.velocity().x(), 20.0 / (1.0 + 20.0 * 2.0 / length), 0.01);
}

TEST(MediumForce, CarriesABodyAlongWithTheWind) {
    OneBody flight(ball(0.05));
    flight.add(Medium{.density = 1.2, .velocity = {3, 0, -4}, .dragCoefficient = 1.0});
    support::run(flight.world, 6000);
    EXPECT_LT((flight.velocity() - Vec3(3, 0, -4)).norm(), 0.01);
}

// A cube of half the density of water floats half submerged.
TEST(MediumForce, LetsACubeFloatAtItsDensity) {
    OneBody flight(support::body(Shape::box({1, 1, 1}), {0, 0.4, 0}, 300.0), kDown);
    flight.add(Medium{.density = 1000, .dragCoefficient = 1.0, .level = 0.0});
    flight.add(Drag{600.0, 100.0});
    support::run(flight.world, 1200);
    EXPECT_NEAR(flight.position().y(), 0.5 - 0.3, 1e-4);
    EXPECT_LT(flight.velocity().norm(), 1e-3);
}

// A small cork bobs with omega^2 = rho g A / m about where it floats.
TEST(MediumForce, ACubeBobsAtItsFrequency) {
    OneBody flight(support::body(Shape::box({1, 1, 1}), {0, 0.05, 0}, 500.0), kDown);
    flight.add(Medium{.density = 1000, .dragCoefficient = 0.0, .level = 0.0});
    const double omega = std::sqrt(1000 * kGravity / 500);
    int steps = 0;
    while (flight.position().y() > 0.0) flight.world.step(1.0 / 600), ++steps;
    EXPECT_NEAR(steps / 600.0, kPi / 2 / omega, 2e-3);
}

TEST(MediumForce, EndsAtItsRegion) {
    BodyDef def = ball(1.0);
    OneBody flight(def);
    Medium wind{.density = 1.2, .velocity = {10, 0, 0}};
    wind.low = {-1, -1, -1}, wind.high = {1, 1, 1};
    flight.add(wind);
    support::run(flight.world, 300);
    EXPECT_GT(flight.position().x(), 1.0);
    const double speed = flight.velocity().x();
    support::run(flight.world, 60);
    EXPECT_EQ(flight.velocity().x(), speed);
}

// T = 2 pi sqrt(r^3 / mu), E = -m mu / (2 r) on a circle
TEST(PointGravityForce, ACircleClosesAfterItsPeriod) {
    BodyDef def = ball(2.0, {4, 0, 0});
    def.velocity = {0, 0, std::sqrt(16.0 / 4.0)};
    OneBody flight(def);
    flight.add(PointGravity{Vec3::Zero(), 16.0, 0.0});
    EXPECT_NEAR(flight.world.energy().total(), -2.0 * 16.0 / (2 * 4.0), 1e-12);
    const double period = 2 * kPi * std::sqrt(64.0 / 16.0);
    support::run(flight.world, 3000, period / 3000);
    EXPECT_LT((flight.position() - Vec3(4, 0, 0)).norm(), 0.01);
    EXPECT_NEAR(flight.world.energy().total(), -4.0, 1e-4);
}

TEST(PointGravityForce, TheCentreItselfDoesNotPull) {
    OneBody flight(ball(1.0));
    flight.add(PointGravity{});
    support::run(flight.world, 10);
    EXPECT_EQ(flight.position(), Vec3::Zero());
}

// T = 2 pi sqrt(m / k); the energy goes from the spring to the body and back.
TEST(SpringForces, SwingWithTheirPeriod) {
    World world;
    world.setGravity(Vec3::Zero());
    const BodyId hook = world.add(support::hook());
    const BodyId bob = world.add(support::body(Shape::sphere(0.1), {1.5, 0, 0}, 2.0));
    SpringForce spring;
    spring.length = 1.0, spring.stiffness = 50.0;
    world.add(ForceDef{spring, {hook, bob}});
    EXPECT_NEAR(world.energy().elastic, 0.5 * 50 * 0.25, 1e-12);
    const double period = 2 * kPi * std::sqrt(2.0 / 50.0);
    support::run(world, 150, period / 300);  // half a period: on the other side
    EXPECT_NEAR(world.pose(bob).position.x(), 0.5, 1e-3);
    support::run(world, 150, period / 300);
    EXPECT_NEAR(world.pose(bob).position.x(), 1.5, 1e-3);
    EXPECT_NEAR(world.energy().total(), 6.25, 0.05);
}

/// A bob of 2 kg pulled along x towards 1 m by a spring of `hz`, from 0.3 m off, without gravity.
struct Swing {
    World world;
    BodyId bob;

    Swing(double hz, double zeta, const Settings& settings = Settings::steady()) : world(settings) {
        world.setGravity(Vec3::Zero());
        const BodyId hook = world.add(support::hook());
        bob = world.add(support::body(Shape::sphere(0.1), {1.3, 0, 0}, 2.0));
        const double w = 2 * kPi * hz;
        SpringForce spring;
        spring.length = 1.0, spring.stiffness = 2.0 * w * w, spring.damping = 4.0 * zeta * w;
        world.add(ForceDef{spring, {hook, bob}});
    }
    double stretch() const { return world.pose(bob).position.x() - 1.0; }
    /// The largest stretch between `from` and `until` (s); it begins with 0.3 m.
    double amplitude(double from, double until) {
        double largest = 0.0;
        while (world.report().time < until) {
            world.step(support::kStep);
            if (world.report().time > from) largest = larger(largest, std::abs(stretch()));
        }
        return largest / 0.3;
    }
};

// From 0.1 Hz to a twentieth of the step rate.
TEST(SpringForces, SwingAHundredTimesWithoutDamping) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double hz : {0.1, 0.7, 1.5, 3.0}) {
            Swing swing(hz, 0.0, settings);
            const double energy = swing.world.energy().total();
            EXPECT_NEAR(swing.amplitude(80.0 / hz, 100.0 / hz), 1.0, 0.01) << hz;
            EXPECT_NEAR(swing.world.energy().total(), energy, 0.02 * energy) << hz;
        }
}

TEST(SpringForces, DecayAsZetaOmegaT) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double hz : {0.3, 1.0, 3.0})
            for (const double zeta : {0.01, 0.1, 0.3, 0.5}) {
                const double w = 2.0 * kPi * hz, damped = w * std::sqrt(1.0 - zeta * zeta);
                const double period = 2.0 * kPi / damped;
                Swing swing(hz, zeta, settings);
                const double peak = swing.amplitude(1.9 * period, 2.1 * period);
                EXPECT_NEAR(peak / std::exp(-zeta * w * 2.0 * period), 1.0, 0.02) << hz << ' ' << zeta;
            }
}

TEST(SpringForces, AreStableAtAnyStiffness) {
    for (const double hz : {10.0, 60.0, 1000.0, 1e6}) {
        Swing swing(hz, 0.0);
        EXPECT_LE(swing.amplitude(0.0, 5.0), 1.01) << hz;
    }
}

// A net of boxes whose corners hang by springs as stiff as steel rods, and a ball that falls on it.
TEST(SpringForces, AreStableInANet) {
    World world;
    constexpr int kSide = 6;
    for (int i = 0; i < kSide * kSide; ++i) {
        const bool edge = i % kSide == 0 || i % kSide == kSide - 1 || i < kSide ||
                          i >= kSide * (kSide - 1);
        BodyDef knot = support::body(Shape::box({0.2, 0.1, 0.2}), Vec3(i % kSide, 0, i / kSide), 0.1);
        if (edge) knot.kind = BodyKind::fixed;
        world.add(knot);
    }
    SpringForce spring;
    spring.stiffness = 1e9, spring.damping = 10.0, spring.length = 0.8;
    spring.anchorA = {0.1, 0, 0}, spring.anchorB = {-0.1, 0, 0};
    for (int i = 0; i < kSide * kSide; ++i) {
        if (i % kSide + 1 < kSide) world.add(ForceDef{spring, {{i}, {i + 1}}});
        SpringForce across = spring;
        across.anchorA = {0, 0, 0.1}, across.anchorB = {0, 0, -0.1};
        if (i + kSide < kSide * kSide) world.add(ForceDef{across, {{i}, {i + kSide}}});
    }
    const BodyId ball = world.add(support::body(Shape::sphere(0.9), {2.5, 1.5, 2.5}, 1.0));
    const double most = world.energy().kinetic + world.energy().potential;
    for (int i = 0; i < 600; ++i) {
        world.step(support::kStep);  // the energy in such springs is not k C^2 / 2
        EXPECT_LT(world.energy().kinetic + world.energy().potential, most + 1e-3) << i;
    }
    EXPECT_GT(world.pose(ball).position.y(), 0.0);
}

TEST(SpringForces, PullBothEndsAlike) {
    World world;
    world.setGravity(Vec3::Zero());
    BodyDef defs[2] = {ball(1.0, {0, 0, 0}), ball(3.0, {2, 1, 0})};
    for (BodyDef& def : defs) def.collide = false;
    const BodyId a = world.add(defs[0]), b = world.add(defs[1]);
    SpringForce spring;
    spring.anchorA = {0, 0.5, 0}, spring.anchorB = {0, 0, 0.5};
    spring.length = 1.0, spring.stiffness = 80.0, spring.damping = 2.0;
    world.add(ForceDef{spring, {a, b}});
    support::run(world, 200);
    EXPECT_LT((world.velocity(a) + 3.0 * world.velocity(b)).norm(), 1e-12);
    const double length = (world.pose(b).toWorld(spring.anchorB) -
                           world.pose(a).toWorld(spring.anchorA)).norm();
    EXPECT_NEAR(length, 1.0, 0.2);
}

// F t = m v while the force lasts, along the body's own axis as the body turns.
TEST(ConstantForces, ActForTheirTime) {
    World world;
    world.setGravity(Vec3::Zero());
    const BodyId body = world.add(ball(2.0));
    world.add(ForceDef{ConstantForce{.force = {4, 0, 0}, .torque = {0, 0.4, 0}}, {body}, 0.5, 1.5});
    support::run(world, 30);
    EXPECT_EQ(world.velocity(body).norm(), 0.0);
    support::run(world, 90);
    EXPECT_NEAR(world.velocity(body).x(), 2.0, 1e-12);
    EXPECT_NEAR(world.spin(body).y(), 0.4 / 0.2, 1e-12);
}

TEST(ConstantForces, TurnWithTheBodyWhenTold) {
    BodyDef def = ball(1.0);
    def.pose.rotation = turnAbout(Vec3::UnitZ(), kPi / 2);
    OneBody flight(def);
    flight.add(ConstantForce{.force = {6, 0, 0}, .turns = true});
    support::run(flight.world, 60);
    EXPECT_LT((flight.velocity() - Vec3(0, 6, 0)).norm(), 1e-12);
}

TEST(ConstantForces, OffTheCentreTurnABody) {
    OneBody flight(ball(1.0));
    flight.add(ConstantForce{.force = {0, 1, 0}, .at = {0.5, 0, 0}});
    flight.world.step(support::kStep);
    EXPECT_GT(flight.world.spin(flight.body).z(), 0.0);
    flight.world.remove(ForceId{0});
    const Vec3 spin = flight.world.spin(flight.body);
    flight.world.step(support::kStep);
    EXPECT_EQ(flight.world.spin(flight.body), spin);
}

// The glide ratio is C_L / C_D, with the wing held level by a tail of large drag.
TEST(AirfoilForce, AGliderSinksByDragOverLift) {
    BodyDef def = support::body(Shape::box({0.5, 0.1, 0.2}), Vec3::Zero(), 1.0);
    Mat3 stiff = Mat3::Identity() * 1e6;  // keeps its attitude
    def.inertia = stiff;
    def.velocity = {12, -0.5, 0};
    OneBody flight(def, kDown);
    Airfoil wing;
    wing.area = 0.25;
    flight.add(wing);
    support::run(flight.world, 6000);
    const Vec3 v = flight.velocity();
    const double speed = v.norm(), sink = -v.y() / speed;
    const AirfoilCoefficients c = coefficientsOf(wing, v.x() / speed, sink);
    EXPECT_NEAR(sink / (v.x() / speed), c.drag / c.lift, 1e-6);
    EXPECT_NEAR(0.5 * 1.2 * speed * speed * 0.25 * std::hypot(c.lift, c.drag), kGravity, 1e-6);
}

TEST(Forces, KeepTheirBodiesAwakeAndNobodyElse) {
    Settings settings = Settings::steady();
    settings.sleeping = true;
    World world = support::stack(1, settings);
    const BodyId other = world.add(support::body(Shape::box({1, 1, 1}), {5, 0.5, 0}));
    const ForceId force = world.add(ForceDef{ConstantForce{.force = {0.1, 0, 0}}, {other}});
    support::run(world, 90);
    EXPECT_TRUE(world.isAsleep({1}));
    EXPECT_FALSE(world.isAsleep(other));
    world.remove(force);
    support::run(world, 90);
    EXPECT_TRUE(world.isAsleep(other));
}

TEST(Forces, WakeWhoSleepsWhenTheyBegin) {
    Settings settings = Settings::steady();
    settings.sleeping = true;
    World world = support::stack(1, settings);
    world.add(ForceDef{ConstantForce{.force = {1e4, 0, 0}}, {BodyId{1}}, 2.0});
    support::run(world, 110);
    EXPECT_TRUE(world.isAsleep({1}));
    support::run(world, 70);
    EXPECT_FALSE(world.isAsleep({1}));
    EXPECT_GT(world.pose({1}).position.x(), 0.5);
}

TEST(Forces, SurviveTheirBodies) {
    World world;
    world.setGravity(Vec3::Zero());
    const BodyId a = world.add(ball(1.0)), b = world.add(ball(1.0, {3, 0, 0}));
    world.add(ForceDef{SpringForce{}, {a, b}});
    world.add(ForceDef{NBodyGravity{1.0, 0.0}, {a, b}});
    world.add(ForceDef{Medium{.velocity = {1, 0, 0}}, {a, b}});
    world.remove(a);
    support::run(world, 10);
    EXPECT_GT(world.velocity(b).x(), 0.0);  // the wind alone
}

}  // namespace
}  // namespace engine
