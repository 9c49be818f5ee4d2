// Rolling resistance compared with closed forms: a moment of rho times the load, about the line of contact.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kGravity;
using support::run;

constexpr double kRollerRadius = 0.3;  // m

struct Solving {
    const char* name;
    Method method;
    bool lanes;
    double exact;  // m/s^2
};
void PrintTo(const Solving& how, std::ostream* out) { *out << how.name; }

Settings settingsOf(const Solving& how) {
    Settings settings = Settings::steady();
    settings.method = how.method;
    settings.lanes = how.lanes;
    return settings;
}

/// A plane inclined down towards +x, and a round body on it.
struct Slope {
    World world;
    BodyId rider;
    Vec3 downhill;

    Slope(double degrees, double rho, const Shape& shape, const Settings& settings,
          double speed = 0.0)
        : world(settings) {
        const double a = radians(degrees);
        const Vec3 normal(sine(a), cosine(a), 0);
        downhill = Vec3(cosine(a), -sine(a), 0);
        world.add(support::fixed(Shape::plane(normal)));
        BodyDef def = body(shape, kRollerRadius * normal, 2.0);
        // A cylinder lies across the slope.
        def.pose.rotation = turnAbout(Vec3::UnitX(), radians(90.0));
        def.material.rolling = rho;
        def.velocity = speed * downhill;
        def.spin = Vec3(0, 0, -speed / kRollerRadius);
        rider = world.add(def);
    }
    double speed() const { return world.velocity(rider).dot(downhill); }
    double acceleration() {
        run(world, 30);
        const double before = speed();
        run(world, 60);
        return speed() - before;
    }
};

class Rolling : public testing::TestWithParam<Solving> {
protected:
    Settings settings() const { return settingsOf(GetParam()); }
    double exact() const { return GetParam().exact; }
};

// a = (g sin - rho / r g cos) / (1 + I / (m r^2)), I / (m r^2) = 2/5 of a ball and 1/2 of a cylinder
TEST_P(Rolling, SlowsWhatRollsDownASlope) {
    const double rho = 0.02, a = radians(10.0);
    const double pull = kGravity * (sine(a) - rho / kRollerRadius * cosine(a));
    Slope ball(10.0, rho, Shape::sphere(kRollerRadius), settings());
    EXPECT_NEAR(ball.acceleration(), pull / 1.4, exact());
    EXPECT_NEAR(-ball.world.spin(ball.rider).z() * kRollerRadius, ball.speed(), 10 * exact());
    Slope roller(10.0, rho, Shape::cylinder(kRollerRadius, 0.5), settings());
    EXPECT_NEAR(roller.acceleration(), pull / 1.5, exact());
}

// v^2 / (2 a), a = rho g / (1.4 r)
TEST_P(Rolling, ABallComesToRestWhereItsEnergyIsSpent) {
    const double rho = 0.01, speed = 1.0;
    Slope level(0.0, rho, Shape::sphere(kRollerRadius), settings(), speed);
    run(level.world, 600);
    EXPECT_LT(level.world.velocity(level.rider).norm(), 1e-4);
    EXPECT_LT(level.world.spin(level.rider).norm(), 1e-3);
    const double way = level.world.pose(level.rider).position.x();
    EXPECT_NEAR(way, 1.4 * kRollerRadius * speed * speed / (2 * rho * kGravity), 0.01 * way);
}

// tan(angle) < rho / r: 3.43 degrees < 3.814 < 4.2
TEST_P(Rolling, HoldsOnASlopeAsLongAsItsMomentIsEnough) {
    const double rho = 0.02;
    Slope holds(3.43, rho, Shape::sphere(kRollerRadius), settings());
    run(holds.world, 300);
    EXPECT_LT(holds.speed(), 1e-4);
    EXPECT_LT((holds.world.pose(holds.rider).position).dot(holds.downhill), 1e-3);
    Slope rolls(4.2, rho, Shape::sphere(kRollerRadius), settings());
    run(rolls.world, 300);
    EXPECT_GT(rolls.speed(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Solvers, Rolling,
                         testing::Values(Solving{"lanes", Method::impulses, true, 2e-4},
                                         Solving{"rows", Method::impulses, false, 2e-4},
                                         Solving{"pgs", Method::pgs, false, 2e-4},
                                         Solving{"pgsMatrix", Method::pgsMatrix, false, 2e-4},
                                         Solving{"direct", Method::direct, false, 1e-6}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(RollingResistance, IsTheLargerOfTheTwoSurfaces) {
    const auto speedOn = [](double ofFloor, double ofBall) {
        World world;
        BodyDef floor = support::floorPlane();
        floor.material.rolling = ofFloor;
        world.add(floor);
        BodyDef ball = body(Shape::sphere(kRollerRadius), {0, kRollerRadius, 0}, 2.0);
        ball.material.rolling = ofBall;
        ball.velocity = Vec3(2, 0, 0), ball.spin = Vec3(0, 0, -2 / kRollerRadius);
        const BodyId id = world.add(ball);
        run(world, 60);
        return world.velocity(id).x();
    };
    const double free = speedOn(0.0, 0.0), slowed = speedOn(0.02, 0.0);
    EXPECT_NEAR(free, 2.0, 1e-3);
    EXPECT_LT(slowed, 1.9);
    EXPECT_EQ(speedOn(0.0, 0.02), slowed);
    EXPECT_EQ(speedOn(0.01, 0.02), slowed);
}

// The moment between two balls acts on both with opposite signs.
TEST(RollingResistance, ChangesNoAngularMomentum) {
    for (const bool lanes : {false, true}) {
        Settings settings = Settings::steady();
        settings.lanes = lanes;
        World world(settings);
        world.setGravity(Vec3::Zero());
        BodyDef def = body(Shape::sphere(0.5), {-0.5, 0, 0}, 2.0);
        def.material.rolling = 0.1, def.material.friction = 0.0;
        def.spin = Vec3(0, 3, 1), def.velocity = Vec3(0.5, 0, 0);
        const BodyId a = world.add(def);
        def.pose.position.x() = 0.5, def.spin = Vec3(0, -1, 2), def.velocity = Vec3(-0.5, 0, 0);
        const BodyId b = world.add(def);
        run(world, 1);
        EXPECT_LT(world.spin(a).y(), 2.9);
        EXPECT_NEAR((world.spin(a) + world.spin(b) - Vec3(0, 2, 3)).norm(), 0.0, 1e-6);
    }
}

}  // namespace
}  // namespace engine
