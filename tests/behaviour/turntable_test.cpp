// Riders on turning bodies: what friction holds has to stay where it is on its carrier. Rows that follow the
// tangent of every step instead let it creep outwards as r e^(w^2 dt t / 2): by 153 mm in a minute at 60 Hz.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;

constexpr double kMinute = 60.0;   // s
constexpr double kCreep = 1e-3;    // m in a minute

Settings rowsOfSteady() {
    Settings settings = Settings::steady();
    settings.lanes = false;
    return settings;
}

const Settings kAll[] = {Settings::steady(), Settings::fast(), Settings::seed(), rowsOfSteady()};
constexpr double kRates[] = {60.0, 240.0};

/// A disc with its upper side through the origin, and riders that move with it from the start.
struct Turntable {
    World world;
    BodyId disc;
    Vec3 spin;

    Turntable(const Settings& settings, const Vec3& spinOfDisc, BodyKind kind = BodyKind::kinematic)
        : world(settings), spin(spinOfDisc) {
        BodyDef def = body(Shape::cylinder(3.0, 0.2), {0, -0.1, 0}, 500.0);
        def.kind = kind;
        def.material.friction = 0.9;
        disc = world.add(def);
        world.setVelocity(disc, Vec3::Zero(), spin);
    }
    BodyId ride(const Shape& shape, const Vec3& at) {
        BodyDef def = body(shape, at);
        def.material.friction = 0.9;
        def.velocity = spin.cross(at);
        def.spin = spin;
        return world.add(def);
    }
    /// Where the disc sees the body.
    Vec3 seen(BodyId id) const { return world.pose(disc).toLocal(world.pose(id).position); }
};

/// How far the disc sees the body move in a minute, after it has settled; drive(t) is called before a step.
template <class Drive>
double creep(Turntable& t, BodyId rider, double hz, Drive drive) {
    const int settling = static_cast<int>(0.5 * hz), all = settling + static_cast<int>(kMinute * hz);
    Vec3 start = t.seen(rider);
    for (int i = 0; i < all; ++i) {
        if (i == settling) start = t.seen(rider);
        drive(i / hz);
        t.world.step(1.0 / hz);
    }
    return (t.seen(rider) - start).norm();
}

constexpr auto kNothing = [](double) {};
const Shape kBox = Shape::box({0.3, 0.3, 0.3});

TEST(Turntable, ABoxStaysInItsPlace) {
    for (const Settings& settings : kAll)
        for (const double hz : kRates) {
            Turntable t(settings, {0, 0.5, 0});
            EXPECT_LT(creep(t, t.ride(kBox, {1.2, 0.15, 0}), hz, kNothing), kCreep) << hz;
        }
}

TEST(Turntable, SoDoesAStackWithItsBoxesOutOfLine) {
    for (const Settings& settings : kAll)
        for (const double hz : kRates) {
            Turntable t(settings, {0, 0.5, 0});
            BodyId top;
            for (int i = 0; i < 3; ++i)
                top = t.ride(Shape::box({0.4, 0.2, 0.4}), {1.2 + 0.1 * i, 0.1 + 0.2 * i, 0.05 * i});
            EXPECT_LT(creep(t, top, hz, kNothing), kCreep) << hz;
        }
}

// The centre goes round a circle of 2 m in 9 s, and the disc turns about it.
TEST(Turntable, SoDoesABoxOnADiscThatGoesInACircle) {
    for (const Settings& settings : kAll) {
        Turntable t(settings, {0, 0.5, 0});
        const BodyId box = t.ride(kBox, {1.2, 0.15, 0});
        const double moved = creep(t, box, 60.0, [&](double now) {
            const Vec3 way(1.4 * cosine(0.7 * now), 0, 1.4 * sine(0.7 * now));
            t.world.setVelocity(t.disc, way, t.spin);
        });
        EXPECT_LT(moved, kCreep);
    }
}

TEST(Turntable, SoDoesABoxOnADiscThatSwings) {
    for (const Settings& settings : kAll)
        for (const Vec3& axis : {Vec3(0, 0.8, 0), Vec3(0, 0, 0.4)}) {  // about its axis, as a see-saw
            Turntable t(settings, {0, 0, 0});
            const BodyId box = t.ride(kBox, {1.2, 0.15, 0});
            const double moved = creep(t, box, 60.0, [&](double now) {
                t.world.setVelocity(t.disc, Vec3::Zero(), cosine(2.0 * now) * axis);
            });
            EXPECT_LT(moved, kCreep);
        }
}

TEST(Turntable, SoDoesAChildOnARoundabout) {
    for (const Settings& settings : kAll) {
        Turntable t(settings, {0, 0.5, 0}, BodyKind::dynamic);
        JointDef hinge;
        hinge.type = JointType::hinge;
        hinge.a = t.world.add(support::hook()), hinge.b = t.disc;
        hinge.anchorA = {0, -0.1, 0}, hinge.axis = {0, 1, 0};
        hinge.free[0].motor = {0.5, 1e5};
        t.world.add(hinge);
        EXPECT_LT(creep(t, t.ride(kBox, {1.2, 0.15, 0}), 60.0, kNothing), kCreep);
    }
}

// A belt in a ring: the disc is put back after every step, and the box goes round.
// Friction holds them inwards where they are now, not where they were when the step began: it does not turn the disc.
TEST(Turntable, ARoundaboutKeepsItsEnergyUnderHeavyBoxes) {
    for (const Settings& settings : kAll)
        for (const double hz : kRates) {
            Turntable t(settings, {0, 2, 0}, BodyKind::dynamic);
            JointDef hinge;
            hinge.type = JointType::hinge, hinge.axis = Vec3::UnitY();
            hinge.a = t.world.add(support::hook({0, -0.1, 0})), hinge.b = t.disc;
            t.world.add(hinge);
            for (const double x : {1.4, -1.4, 1.9}) t.ride(Shape::box({0.6, 0.6, 0.6}), {x, 0.3, x == 1.9 ? 1.0 : 0.0});
            const double start = t.world.energy().total();
            for (int i = 0; i < 10 * hz; ++i) t.world.step(1.0 / hz);
            EXPECT_NEAR(t.world.energy().total(), start, 0.01 * start) << hz;
        }
}

TEST(Turntable, ABeltInARingKeepsItsBoxOnTheCircle) {
    for (const Settings& settings : kAll) {
        Turntable t(settings, {0, 0.5, 0});
        const BodyId box = t.ride(kBox, {1.2, 0.15, 0});
        for (int i = 0; i < 3600; ++i) {
            t.world.setPose(t.disc, support::at({0, -0.1, 0}));
            t.world.step(support::kStep);
        }
        const Vec3 at = t.world.pose(box).position;
        EXPECT_NEAR(std::hypot(at.x(), at.z()), 1.2, kCreep);
    }
}

// A ball that rolls on a turntable goes round at 2/7 of its rate, here about the same centre.
TEST(Turntable, ABallGoesRoundAtTwoSevenths) {
    for (const Settings& settings : kAll)
        for (const double hz : kRates) {
            constexpr double kRadius = 0.2, kFrom = 1.2;  // m
            Turntable t(settings, {0, 2.0, 0});
            const Vec3 at(kFrom, kRadius, 0);
            const BodyId ball = t.ride(Shape::sphere(kRadius), at);
            const Vec3 way = 2.0 / 7.0 * t.spin.cross(at);
            const Vec3 roll = Vec3::UnitY().cross(way - t.spin.cross(at)) / kRadius;
            t.world.setVelocity(ball, way, roll);
            for (int i = 0; i < static_cast<int>(kMinute * hz); ++i) {
                t.world.step(1.0 / hz);
                const Vec3 now = t.world.pose(ball).position;
                ASSERT_NEAR(std::hypot(now.x(), now.z()), kFrom, 2e-3);
            }
            const Vec3 now = t.world.pose(ball).position;
            const double angle = 2.0 / 7.0 * t.spin.y() * kMinute;
            EXPECT_NEAR(now.x(), kFrom * cosine(angle), 0.03 * kFrom);
            EXPECT_NEAR(now.z(), -kFrom * sine(angle), 0.03 * kFrom);
        }
}

}  // namespace
}  // namespace engine
