// Lift and drag of a wing against the angle of attack.
#include "engine/forces/airfoil.h"

#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

AirfoilCoefficients atAngle(const Airfoil& airfoil, double degrees) {
    const double alpha = radians(degrees);
    return coefficientsOf(airfoil, cosine(alpha), sine(alpha));
}

/// N, on a wing that is held at `degrees` to a wind of 10 m/s along -x.
Vec3 forceAt(const Airfoil& airfoil, double degrees) {
    World world;
    world.setGravity(Vec3::Zero());
    BodyDef def = support::body(Shape::box({1, 0.1, 2}), Vec3::Zero(), 2.0);
    def.pose.rotation = turnAbout(Vec3::UnitZ(), radians(degrees));
    const BodyId wing = world.add(def);
    world.add(ForceDef{airfoil, {wing}});
    constexpr double dt = 1e-6;  // s: only in the first sub-step is the body at rest
    Settings once = Settings::steady();
    once.substeps = once.maxSubsteps = 1;
    world.setSettings(once);
    world.step(dt);
    return 2.0 * world.velocity(wing) / dt;
}

Airfoil inWind() {
    Airfoil airfoil;
    airfoil.wind = {-10, 0, 0};
    airfoil.area = 0.5;
    return airfoil;
}

// C_L = 2 pi sin(alpha), C_D = C_0 + C_L^2 / (pi AR)
TEST(Airfoil, AttachedAirLiftsWithTheSineOfTheAngle) {
    const Airfoil airfoil;
    for (const double degrees : {-12.0, -3.0, 0.0, 5.0, 14.0}) {
        const double lift = 2 * kPi * sine(radians(degrees));
        EXPECT_NEAR(atAngle(airfoil, degrees).lift, lift, 1e-14);
        EXPECT_NEAR(atAngle(airfoil, degrees).drag, 0.02 + lift * lift / (kPi * 8.0), 1e-14);
    }
}

// Beyond the stall: a plate, C_L = C_n sin cos, C_D = C_0 + C_n sin^2, whose ratio is cot(alpha).
TEST(Airfoil, StalledItIsAPlate) {
    const Airfoil airfoil;
    EXPECT_NEAR(atAngle(airfoil, 45).lift, 1.0, 1e-14);
    EXPECT_NEAR(atAngle(airfoil, 45).drag, 1.02, 1e-14);
    EXPECT_NEAR(atAngle(airfoil, 90).lift, 0.0, 1e-14);
    EXPECT_NEAR(atAngle(airfoil, 90).drag, 2.02, 1e-14);
}

TEST(Airfoil, TheStallTakesMostOfTheLiftAndAddsDrag) {
    const Airfoil airfoil;  // at 14.9 degrees
    EXPECT_GT(atAngle(airfoil, 14.8).lift, 1.6);
    EXPECT_LT(atAngle(airfoil, 21.0).lift, 0.7);
    EXPECT_GT(atAngle(airfoil, 21.0).drag, 2.0 * atAngle(airfoil, 10.0).drag);
    double before = atAngle(airfoil, 14.8).lift;
    for (double degrees = 14.9; degrees < 30.0; degrees += 0.1) {  // without a jump
        const double lift = atAngle(airfoil, degrees).lift;
        EXPECT_LT(std::abs(lift - before), 0.05) << degrees;
        before = lift;
    }
}

TEST(Airfoil, ASurfaceIsNeverAttached) {
    Airfoil surface;
    surface.stall = 0.0;
    EXPECT_NEAR(atAngle(surface, 5).lift, 2 * sine(radians(5)) * cosine(radians(5)), 1e-14);
}

// L = rho/2 v^2 A C_L across the wind, D along it.
TEST(Airfoil, PushesABodyAcrossAndAlongTheWind) {
    const Airfoil airfoil = inWind();
    const double pressure = 0.5 * 1.2 * 100 * 0.5;
    const double lift = 2 * kPi * sine(radians(10));
    const Vec3 force = forceAt(airfoil, 10.0);
    EXPECT_NEAR(force.y(), pressure * lift, 1e-3);
    EXPECT_NEAR(force.x(), -pressure * (0.02 + lift * lift / (8 * kPi)), 1e-3);
    EXPECT_NEAR(forceAt(airfoil, -10.0).y(), -pressure * lift, 1e-3);
}

// A fin behind the centre of mass turns a body into the wind.
TEST(Airfoil, AFinBehindTurnsTheBodyIntoTheWind) {
    World world;
    world.setGravity(Vec3::Zero());
    BodyDef def = support::body(Shape::box({2, 0.1, 0.1}), Vec3::Zero(), 1.0);
    def.pose.rotation = turnAbout(Vec3::UnitZ(), radians(20));
    const BodyId vane = world.add(def);
    Airfoil fin = inWind();
    fin.at = {-1, 0, 0};
    world.add(ForceDef{fin, {vane}});
    world.step(1.0 / 60.0);
    EXPECT_LT(world.spin(vane).z(), 0.0);
}

}  // namespace
}  // namespace engine
