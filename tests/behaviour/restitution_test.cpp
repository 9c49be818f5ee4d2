// mission 34: J v2 = -e J v1, with a threshold.
#include <gtest/gtest.h>

#include <array>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kGravity;
using support::kStep;
using support::run;

/// Highest point after the first bounce of a ball dropped from 2 m (its lowest point).
double reboundHeight(double e, const Settings& settings) {
    World world(settings);
    BodyDef floor = support::floorPlane();
    world.add(floor);
    BodyDef ball = body(Shape::sphere(0.25), {0, 2.25, 0});
    ball.material.restitution = e;
    const BodyId id = world.add(ball);
    double highest = 0.0;
    bool bounced = false;
    for (int i = 0; i < 150; ++i) {
        world.step(kStep);
        bounced = bounced || world.velocity(id).y() > 0.0;
        if (bounced) highest = larger(highest, world.pose(id).position.y() - 0.25);
    }
    return highest;
}

TEST(Restitution, RisesToESquared) {
    for (const double e : {0.3, 0.5, 0.8, 1.0}) {
        EXPECT_NEAR(reboundHeight(e, Settings::steady()), 2.0 * e * e, 2e-3) << e;
        // Up to half a step's fall is lost or gained if the hit is between two steps.
        EXPECT_NEAR(reboundHeight(e, Settings::seed()), 2.0 * e * e, 0.25) << e;
    }
}

/// A ball dropped from a metre, for a minute: the height of every bounce, by its energy.
struct Bounces {
    std::vector<double> heights;  // m
    double lowest = 1.0;          // m, of its lowest point at ends of steps

    Bounces(double e, const Settings& settings) {
        World world(settings);
        world.add(support::floorPlane());
        BodyDef ball = body(Shape::sphere(0.25), {0, 1.25, 0}, 1.0);
        ball.material.restitution = e;
        const BodyId id = world.add(ball);
        double before = 0.0;
        for (int i = 0; i < 3600; ++i) {
            world.step(kStep);
            const double v = world.velocity(id).y();
            if (v > 0.0 && before <= 0.0)
                heights.push_back(world.energy().total() / kGravity - 0.25);
            before = v;
            lowest = smaller(lowest, world.pose(id).position.y() - 0.25);
        }
    }
};

TEST(Restitution, KeepsTheEnergyOfAMinuteOfBounces) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        const Bounces bounces(1.0, settings);
        EXPECT_GT(bounces.heights.size(), 60u);
        EXPECT_NEAR(bounces.heights.back(), 1.0, 1e-3);
        EXPECT_GT(bounces.lowest, -1e-4);
        EXPECT_LT(bounces.lowest, 1e-3);
    }
}

TEST(Restitution, RisesToEToTheTwiceNthAndComesToRest) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        const Bounces bounces(0.8, settings);
        ASSERT_GE(bounces.heights.size(), 8u);
        for (int n = 0; n < 8; ++n)
            EXPECT_NEAR(bounces.heights[n] / std::pow(0.64, n + 1), 1.0, 0.005) << n;
        EXPECT_GT(bounces.lowest, -6e-4);  // and rests on the floor at the end
    }
}

// A ball thrown at the floor slips, or grips and leaves rolling: mu (1 + e) v compared with 2/7 v.
TEST(Restitution, OfAnObliqueHitIsNewtonsAndCoulombs) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double v : {3.0, 10.0, 30.0, 100.0})
            for (const double mu : {0.0, 0.1, 0.8}) {
                World world(settings);
                world.setGravity(Vec3::Zero());
                BodyDef floor = support::floorPlane();
                floor.material.friction = mu;
                world.add(floor);
                BodyDef ball = body(Shape::sphere(0.25), {0, 1.25, 0}, 3.0);
                ball.material.restitution = 0.5, ball.material.friction = mu;
                ball.velocity = {v, -v, 0};
                const BodyId id = world.add(ball);
                run(world, 60);
                const double lost = smaller(mu * 1.5, 2.0 / 7.0) * v;
                EXPECT_NEAR(world.velocity(id).y() / v, 0.5, 5e-4) << v << ' ' << mu;
                EXPECT_NEAR(world.velocity(id).x() / v, 1.0 - lost / v, 5e-4) << v << ' ' << mu;
                EXPECT_NEAR(world.spin(id).z(), -2.5 * lost / 0.25, 5e-3 * v) << v << ' ' << mu;
            }
}

/// Two balls without friction, of which one hits the other, at rest, `offset` (m) beside its centre.
struct ObliqueHit {
    static constexpr double kRadius = 0.25, kMassA = 2.0, kMassB = 3.0;  // m, kg
    Vec3 velocity, expected;                                             // m/s, of the first
    double turned = 0.0;                                                 // rad/s that it gains
    double angular = 0.0;  // kg m^2/s, change of the angular momentum about the origin

    ObliqueHit(double e, double v, double offset, double phase, const Settings& settings) {
        World world(settings);
        world.setGravity(Vec3::Zero());
        const double away = 2.0 * kRadius;
        BodyDef a = body(Shape::sphere(kRadius), {-1.0 - away - phase * v * kStep, offset, 0}, kMassA);
        BodyDef b = body(Shape::sphere(kRadius), {0, 0, 0}, kMassB);
        a.velocity = {v, 0, 0}, a.spin = {0, 0, 20.0};
        for (BodyDef* def : {&a, &b}) def->material.restitution = e, def->material.friction = 0.0;
        const BodyId first = world.add(a), second = world.add(b);
        run(world, static_cast<int>((1.0 + away) / v / kStep) + 30);
        const Vec3 n = Vec3(std::sqrt(away * away - offset * offset), -offset, 0) / away;
        const double impulse = (1.0 + e) * v * n.x() / (1.0 / kMassA + 1.0 / kMassB);
        velocity = world.velocity(first), expected = Vec3(v, 0, 0) - impulse / kMassA * n;
        turned = (world.spin(first) - a.spin).norm() + world.spin(second).norm();
        const auto momentum = [&](BodyId id, double mass) {
            return Vec3(mass * world.pose(id).position.cross(world.velocity(id)));
        };
        angular = (momentum(first, kMassA) + momentum(second, kMassB)).z() + kMassA * v * offset;
    }
};

// Both move on along the line of the centres at the moment of the impact, whenever in the step that is.
TEST(Restitution, OfTwoBallsIsAlongTheLineOfTheirCentres) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double e : {0.0, 0.5, 1.0})
            for (const double v : {0.5, 1.0, 2.0, 5.0, 20.0, 100.0})
                for (const double offset : {0.1, 0.3, 0.4})
                    for (const double phase : {0.0, 0.3, 0.6, 0.9}) {
                        const ObliqueHit hit(e, v, offset, phase, settings);
                        EXPECT_LT((hit.velocity - hit.expected).norm() / v, 3e-3)
                            << e << ' ' << v << ' ' << offset << ' ' << phase;
                        EXPECT_NEAR(hit.turned, 0.0, 1e-3 * v) << e << ' ' << v << ' ' << offset;
                        EXPECT_NEAR(hit.angular, 0.0, 3e-3 * v) << e << ' ' << v << ' ' << offset;
                    }
}

/// The largest rise and loss of energy in `seconds`, as a share of `scale` (J).
std::array<double, 2> riseAndLoss(World& world, double scale, double seconds) {
    const double start = world.energy().total();
    std::array<double, 2> worst{};
    for (int i = 0; i < seconds / kStep; ++i) {
        world.step(kStep);
        const double change = (world.energy().total() - start) / scale;
        worst[0] = larger(worst[0], change), worst[1] = larger(worst[1], -change);
    }
    return worst;
}

BodyDef elastic(BodyDef def) {
    def.material.restitution = 1.0, def.material.friction = 0.0;
    return def;
}

// A corner hits, the body turns over, another corner hits: each takes only its own share.
TEST(Restitution, KeepsTheEnergyOfBodiesThatTumble) {
    const Shape shapes[] = {Shape::box({0.5, 0.5, 0.5}), Shape::box({1.0, 0.2, 0.4}), Shape::cylinder(0.25, 0.5),
                            Shape::capsule(0.25, 1.0), Shape::cone(0.25, 0.5)};
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double tilt : {0.0, 0.3})
            for (const Shape& shape : shapes) {
                World world(settings);
                world.add(elastic(support::floorPlane()));
                BodyDef def = elastic(body(shape, {0, 1.5, 0}, 1.0));
                def.pose.rotation = engine::turnAboutXyz({tilt, 0.3 * tilt, 0.7 * tilt});
                world.add(def);
                const auto [rise, loss] = riseAndLoss(world, kGravity, 20.0);
                EXPECT_LT(rise, 0.01) << static_cast<int>(shape.type) << ' ' << tilt;
                EXPECT_LT(loss, 0.01) << static_cast<int>(shape.type) << ' ' << tilt;
            }
}

/// A body that is thrown at the floor with `speed` and `spin`, tilted about every axis.
BodyDef thrownDown(const Shape& shape, double speed, double spin) {
    BodyDef def = body(shape, {0, 3, 0}, 1.0);
    def.pose.rotation = engine::turnAboutXyz({0.2, 0.35, 0.55});
    def.velocity = {1, -speed, 0.5}, def.spin = spin * Vec3(0.6, 0.2, -0.7);
    return def;
}

// A corner bounces near the end of a sub-step, while another one comes down that touched at its beginning.
TEST(Restitution, KeepsTheEnergyOfBodiesThrownHard) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const Shape& shape : {Shape::box({0.5, 0.5, 0.5}), Shape::box({0.5, 0.05, 0.5}),
                                   Shape::box({0.5, 0.05, 0.05}), Shape::cone(0.3, 0.5)})
            for (const double speed : {0.0, 10.0, 30.0})
                for (const double spin : {0.0, 3.0, 20.0}) {
                    World world(settings);
                    world.add(elastic(support::floorPlane()));
                    world.add(elastic(thrownDown(shape, speed, spin)));
                    const auto [rise, loss] = riseAndLoss(world, world.energy().total(), 20.0);
                    EXPECT_LT(rise, 0.01) << static_cast<int>(shape.type) << ' ' << speed << ' ' << spin;
                    EXPECT_LT(loss, 0.01) << static_cast<int>(shape.type) << ' ' << speed << ' ' << spin;
                }
}

// Friction acts from the impact on, too: not from the beginning of its sub-step.
TEST(Restitution, WithFrictionLeavesNoCornerInTheFloor) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double speed : {0.0, 10.0, 30.0})
            for (const double spin : {0.0, 3.0, 20.0}) {
                World world(settings);
                world.add(support::floorPlane());
                BodyDef cube = thrownDown(Shape::box({0.5, 0.5, 0.5}), speed, spin);
                cube.material.restitution = 0.5, cube.material.friction = 0.5;
                const BodyId id = world.add(cube);
                double lowest = 1.0;
                for (int i = 0; i < 600; ++i) {
                    world.step(kStep);
                    for (int k = 0; k < 8; ++k) {
                        const Vec3 corner(k & 1 ? 0.25 : -0.25, k & 2 ? 0.25 : -0.25, k & 4 ? 0.25 : -0.25);
                        lowest = smaller(lowest, world.pose(id).toWorld(corner).y());
                    }
                }
                EXPECT_GT(lowest, -0.003) << speed << ' ' << spin;
            }
}

// What it rests on acts from the impact on as well.
TEST(Restitution, OfABallOnABoxDoesNotLiftTheBox) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double e : {0.0, 0.5, 0.9})
            for (const double speed : {5.0, 10.0, 30.0}) {
                World world(settings);
                world.add(support::floorPlane());
                const BodyId box = world.add(body(Shape::box({1, 0.5, 1}), {0, 0.25, 0}, 500.0));
                BodyDef ball = body(Shape::sphere(0.25), {0.1, 3.637, 0.05}, 65.0);
                ball.velocity = {1, -speed, 0}, ball.material.restitution = e;
                world.add(ball);
                double highest = 0.0;
                for (int i = 0; i < 60; ++i) {
                    world.step(kStep);
                    highest = larger(highest, world.pose(box).position.y() - 0.25);
                }
                EXPECT_LT(highest, 2e-4) << e << ' ' << speed;
            }
}

TEST(Restitution, KeepsTheEnergyOfBallsInABox) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world(settings);
        world.setGravity(Vec3::Zero());
        for (int k = 0; k < 6; ++k) {
            Vec3 size(4, 4, 4), at = Vec3::Zero();
            size[k / 2] = 1.0, at[k / 2] = k % 2 ? 2.5 : -2.5;
            world.add(elastic(support::fixed(Shape::box(size), at)));
        }
        double scale = 0.0;
        for (int i = 0; i < 27; ++i) {
            const Vec3 at = 1.3 * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            BodyDef ball = elastic(body(Shape::sphere(0.2), at, 1.0 + i % 3));
            ball.velocity = Vec3(i * 7 % 11 - 5, i * 5 % 11 - 5, i * 3 % 11 - 5);
            ball.spin = Vec3(i % 5 - 2, i % 7 - 3, i % 3 - 1);
            scale += 0.5 * (1.0 + i % 3) * ball.velocity.squaredNorm();
            world.add(ball);
        }
        const auto [rise, loss] = riseAndLoss(world, scale, 20.0);
        EXPECT_LT(rise, 1e-3);
        EXPECT_LT(loss, 1e-2);
    }
}

TEST(Restitution, SlowContactsDoNotBounce) {
    World world;
    world.add(support::floorPlane());
    BodyDef ball = body(Shape::sphere(0.25), {0, 0.252, 0});
    ball.material.restitution = 0.9;
    const BodyId id = world.add(ball);
    run(world, 60);
    EXPECT_LT(world.velocity(id).norm(), 1e-3);
    EXPECT_NEAR(world.pose(id).position.y(), 0.25, 1e-3);
}

TEST(Restitution, ABoxDroppedFlatStaysFlat) {
    World world;
    world.add(support::floorPlane());
    BodyDef box = body(Shape::box({1, 1, 1}), {0, 1.5, 0});
    box.material.restitution = 0.5;
    const BodyId id = world.add(box);
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        ASSERT_LT(world.spin(id).norm(), 2e-5);  // contacts are solved in single precision
    }
}

// One ball in, one ball out: for equal masses, momentum and energy allow nothing else.
TEST(Cradle, ABlowTravelsThroughARowOfTouchingBalls) {
    World world;
    world.setGravity(Vec3::Zero());
    for (int i = 0; i < 5; ++i) {
        BodyDef ball = body(Shape::sphere(0.25), {0.5 * i + (i > 0 ? 0.3 : 0.0), 0, 0});
        ball.material.restitution = 1.0;
        ball.material.friction = 0.0;
        if (i == 0) ball.velocity = {2, 0, 0};
        world.add(ball);
    }
    run(world, 30);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(world.velocity({i}).norm(), 0.0, 1e-9) << i;
    EXPECT_NEAR(world.velocity({4}).x(), 2.0, 1e-9);
}

TEST(Cradle, TwoBallsInTwoBallsOut) {
    World world;
    world.setGravity(Vec3::Zero());
    for (int i = 0; i < 5; ++i) {
        BodyDef ball = body(Shape::sphere(0.25), {0.5 * i + (i > 1 ? 0.3 : 0.0), 0, 0});
        ball.material.restitution = 1.0;
        ball.material.friction = 0.0;
        if (i < 2) ball.velocity = {2, 0, 0};
        world.add(ball);
    }
    run(world, 30);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(world.velocity({i}).norm(), 0.0, 1e-6) << i;
    for (int i = 3; i < 5; ++i) EXPECT_NEAR(world.velocity({i}).x(), 2.0, 1e-6) << i;
}

}  // namespace
}  // namespace engine
