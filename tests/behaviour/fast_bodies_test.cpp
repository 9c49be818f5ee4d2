// Bodies that move many times their size in one step: they neither pass through what they should hit, nor are
// stopped by what they only pass.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/joints.h"

namespace engine {
namespace {

using support::body;
using support::fixed;
using support::kStep;
using support::run;
using support::weightless;

constexpr double kFast = 200.0;  // m/s: 3.3 m per step
const Vec3 kThin{0.02, 60, 60};  // m, a wall across x

/// A direction turned away from +x.
Vec3 heading(double degreesUp, double degreesAside) {
    return engine::turnAboutXyz({0, radians(degreesAside), radians(degreesUp)}) * Vec3::UnitX();
}

/// A body that starts `ahead` metres before a point of the wall and flies at it.
BodyDef thrown(const Shape& shape, const Vec3& direction, double ahead) {
    BodyDef def = body(shape, Vec3(-0.06 - ahead, 0, 0) - direction.cwiseProduct(Vec3(0, 1, 1)) *
                                                              (ahead / direction.x()));
    def.velocity = kFast * direction;
    return def;
}

/// The largest x of the body's centre while it is next to the wall.
double farthest(World& world, BodyId id, int steps) {
    double x = -1e9;
    for (int i = 0; i < steps; ++i) {
        world.step(kStep);
        if (world.pose(id).position.cwiseAbs().tail<2>().maxCoeff() < 30.0)
            x = std::max(x, world.pose(id).position.x());
    }
    return x;
}

TEST(FastBall, DoesNotPassAThinWallFromAnyAngle) {
    for (const double up : {0.0, 15.0, 40.0, 65.0, 80.0})
        for (const double aside : {0.0, 10.0, 30.0})
            for (int k = 0; k < 12; ++k) {  // twelve places of the impact within the step
                World world = weightless();
                world.add(fixed(Shape::box(kThin)));
                const Vec3 direction = heading(up, aside);
                const double ahead = 0.05 + k * kFast * kStep / 12 * direction.x();
                const BodyId ball = world.add(thrown(Shape::sphere(0.05), direction, ahead));
                const double x = farthest(world, ball, 4);
                EXPECT_LT(x, -0.06 + 0.002) << up << " " << aside << " " << k;
                EXPECT_GT(x, -0.06 - 0.01) << up << " " << aside << " " << k;  // it was there
            }
}

TEST(FastBall, StopsAtAWallWithoutRestitution) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double v : {50.0, 350.0, 470.0})
            for (const double radius : {0.05, 0.5})
                for (int k = 0; k < 6; ++k) {
                    World world(settings);
                    world.setGravity(Vec3::Zero());
                    world.add(fixed(Shape::box({1, 20, 20})));
                    BodyDef def = body(Shape::sphere(radius), {-0.5 - radius - (1 + k / 6.0) * v * kStep, 0, 0});
                    def.velocity = {v, 0, 0};
                    const BodyId ball = world.add(def);
                    run(world, 10);
                    EXPECT_LT(world.velocity(ball).norm(), 0.01) << v << ' ' << radius << ' ' << k;
                    EXPECT_NEAR(world.pose(ball).position.x(), -0.5 - radius, 2e-3) << v << ' ' << radius << ' ' << k;
                }
}

TEST(FastBall, DoesNotPassAWallThatComesTowardIt) {
    for (const BodyKind kind : {BodyKind::kinematic, BodyKind::dynamic})
        for (int k = 0; k < 12; ++k) {
            World world = weightless();
            BodyDef wall = body(Shape::box(kThin), Vec3::Zero(), 1000.0);
            wall.kind = kind, wall.velocity = {-30, 0, 0};
            const BodyId id = world.add(wall);
            const BodyId ball =
                world.add(thrown(Shape::sphere(0.05), Vec3::UnitX(), 0.1 + 0.3 * k));
            run(world, 5);
            const double apart = world.pose(id).position.x() - world.pose(ball).position.x();
            EXPECT_GT(apart, 0.06 - 0.002) << k;
            EXPECT_LT(apart, 0.2) << k;  // carried along
        }
}

TEST(FastBall, DoesNotPassAThinBoxThatTurns) {
    for (int k = 0; k < 24; ++k) {
        World world = weightless();
        BodyDef plate = body(Shape::box(kThin), Vec3::Zero(), 1e6);
        plate.spin = {0, 0, 2};
        plate.pose.rotation = turnAboutXyz({0, 0, radians(-3)});
        const BodyId wall = world.add(plate);
        const BodyId ball = world.add(thrown(Shape::sphere(0.05), Vec3::UnitX(), 0.3 + 0.15 * k));
        run(world, 3);
        EXPECT_LT(world.pose(wall).toLocal(world.pose(ball).position).x(), -0.06 + 0.006) << k;
    }
}

TEST(FastRod, DoesNotPassAThinWall) {
    for (const bool box : {false, true})
        for (const double spin : {0.0, 10.0, 30.0})
            for (int k = 0; k < 12; ++k) {
                World world = weightless();
                world.add(fixed(Shape::box(kThin)));
                const Shape shape =
                    box ? Shape::box({0.06, 1, 0.06}) : Shape::capsule(0.03, 1.0);
                BodyDef rod = thrown(shape, Vec3::UnitX(), 0.6 + 0.3 * k);
                rod.spin = {0, 0, spin};
                const BodyId id = world.add(rod);
                for (int i = 0; i < 4; ++i) {
                    world.step(kStep);
                    for (const double end : {-0.47, 0.47}) {
                        const Vec3 tip = world.pose(id).toWorld({0, end, 0});
                        EXPECT_LT(tip.x(), 0.0) << box << " " << spin << " " << k << " " << i;
                    }
                }
            }
}

TEST(FastRod, ASpinningRodDoesNotSweepThroughABall) {
    for (int k = 0; k < 24; ++k) {  // the rod's tip moves at 50 m/s, 0.83 m per step
        World world = weightless();
        BodyDef rod = body(Shape::box({0.02, 2, 0.02}), Vec3::Zero(), 100.0);
        rod.spin = {0, 0, 50};
        rod.pose.rotation = turnAboutXyz({0, 0, radians(-15.0 * k)});
        world.add(rod);
        const BodyId ball = world.add(body(Shape::sphere(0.05), {0.8, 0, 0}, 0.1));
        run(world, 12);
        EXPECT_GT(world.velocity(ball).norm(), 10.0) << k;  // it was hit
    }
}

TEST(FastBodies, TwoBulletsMeet) {
    for (const double speed : {kFast, 0.3 * kFast})
        for (int k = 0; k < 12; ++k) {
            World world = weightless();
            BodyDef left = body(Shape::sphere(0.05), {-1.0 - 0.5 * k, 0, 0});
            BodyDef right = body(Shape::sphere(0.05), {1.0 + 0.1 * k, 0, 0});
            left.velocity = {kFast, 0, 0}, right.velocity = {-speed, 0, 0};
            const BodyId a = world.add(left), b = world.add(right);
            for (int i = 0; i < 4; ++i) {
                world.step(kStep);
                EXPECT_GT(world.pose(b).position.x() - world.pose(a).position.x(), 0.098) << k;
            }
            const double together = 0.5 * (kFast - speed);  // e = 0
            EXPECT_NEAR(world.velocity(a).x(), together, 0.01) << k;
            EXPECT_NEAR(world.velocity(b).x(), together, 0.01) << k;
        }
}

// The impulse needs the arms at the impact, several metres ahead: with other arms the bullet is spun instead
// of deflected.
TEST(FastBodies, ABulletGlancesOffAHeavyBallThatComesTowardIt) {
    for (const double offset : {0.0, 0.1, 0.2, 0.3})
        for (int k = 0; k < 12; ++k) {
            World world = weightless();
            BodyDef heavy = body(Shape::sphere(0.4), {0, 0, 0}, 1e6);
            BodyDef bullet = body(Shape::sphere(0.05), {-2.0 - 0.3 * k, offset, 0}, 0.01);
            heavy.material.friction = bullet.material.friction = 0.0;
            heavy.velocity = {-50, 0, 0}, bullet.velocity = {kFast, 0, 0};
            const BodyId a = world.add(heavy), b = world.add(bullet);
            for (int i = 0; i < 4; ++i) {
                world.step(kStep);
                EXPECT_GT((world.pose(a).position - world.pose(b).position).norm(), 0.45 - 0.005)
                    << offset << " " << k;
            }
            EXPECT_LT(world.velocity(b).x(), kFast - 50) << offset << " " << k;
            EXPECT_LT(world.spin(b).norm(), 1e-3 * kFast / 0.05) << offset << " " << k;
        }
}

TEST(FastBodies, PassingAPostChangesNothing) {
    const Shape posts[] = {Shape::box({0.1, 3, 0.1}), Shape::capsule(0.05, 3), Shape::sphere(0.05)};
    const Shape flying[] = {Shape::sphere(0.05), Shape::box({0.1, 0.1, 0.1}), Shape::capsule(0.05, 0.4)};
    for (const Shape& post : posts)
        for (const Shape& shape : flying)
            for (const double beside : {0.005, 0.02, 0.3})
                for (int k = 0; k < 12; ++k) {
                    BodyDef def = body(shape, {-4.0 - 0.3 * k, 0, 0.1 + beside});
                    if (shape.type == ShapeType::sphere) def.spin = {3, 4, 5};
                    def.velocity = {kFast, 0, 0};
                    World world = weightless(), empty = weightless();
                    BodyDef ghost = fixed(post);
                    world.add(ghost);
                    ghost.collide = false;
                    empty.add(ghost);
                    world.add(def), empty.add(def);
                    run(world, 4), run(empty, 4);
                    EXPECT_EQ(world.hash(), empty.hash()) << beside << " " << k;
                }
}

TEST(FastBodies, PassingATiltedBoxChangesNothing) {
    for (int k = 0; k < 24; ++k) {
        World world = weightless();
        BodyDef post = fixed(Shape::box({1, 1, 1}));
        post.pose.rotation = turnAboutXyz({0, 0, radians(45)});
        world.add(post);
        BodyDef def = body(Shape::box({0.2, 0.2, 0.2}), {-2.0 - 0.15 * k, 0.85, 0});
        def.velocity = {kFast, 0, 0};  // 4 cm above the edge
        const BodyId id = world.add(def);
        run(world, 3);
        EXPECT_EQ(world.velocity(id), def.velocity) << k;
        EXPECT_EQ(world.spin(id), def.spin) << k;
    }
}

/// The lowest y of any corner of a box over `steps` steps.
double lowestCorner(World& world, BodyId id, int steps) {
    double lowest = 1e9;
    const Vec3 half = world.def(id).shape.halfSize;
    for (int i = 0; i < steps; ++i) {
        world.step(kStep);
        for (int k = 0; k < 8; ++k) {
            const Vec3 sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
            lowest = std::min(lowest, world.pose(id).toWorld(sign.cwiseProduct(half)).y());
        }
    }
    return lowest;
}

/// A body's speed (m/s) along x after it has passed one at rest, at `gap` (m) beside it.
double speedAfterPassing(const Shape& shape, double size, double speed, double gap, double phase,
                         const Settings& settings) {
    World world(settings);
    world.setGravity(Vec3::Zero());
    BodyDef mover = body(shape, {-3.0 * size - phase * speed * kStep, size + gap, 0});
    mover.velocity = {speed, 0, 0};
    const BodyId id = world.add(mover);
    const BodyId other = world.add(body(shape, {0, 0, 0}));
    run(world, static_cast<int>(6.0 * size / speed / kStep) + 10);
    return world.velocity(id).x() - world.velocity(other).norm() - world.velocity(id).tail<2>().norm();
}

// Less than the margin in a step, and a margin that is larger than the body: a contact ahead would stop them.
TEST(SlowBodies, PassingAnotherChangesNothing) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double size : {0.01, 0.04, 0.2})
            for (const Shape& shape :
                 {Shape::sphere(size / 2), Shape::box({size, size, size}), Shape::cylinder(size / 2, size),
                  Shape::capsule(size / 2, size),
                  Shape::compound(std::array{ShapePart{Shape::box({size, size / 2, size}), {{0, size / 4, 0}}},
                                             ShapePart{Shape::box({size, size / 2, size}), {{0, -size / 4, 0}}}})})
                for (const double speed : {0.1, 0.4, 1.1})
                    for (const double gap : {0.001, 0.004, 0.015})
                        for (const double phase : {0.0, 0.3, 0.7})
                            EXPECT_NEAR(speedAfterPassing(shape, size, speed, gap, phase, settings), speed, 1e-9)
                                << static_cast<int>(shape.type) << ' ' << size << ' ' << gap << ' ' << phase;
}

TEST(FastBox, LandsFlatWithoutSinkingIn) {
    for (int k = 0; k < 12; ++k)
        for (const double tilt : {0.0, 0.5, 5.0}) {
            World world;
            world.add(fixed(Shape::box({20, 0.1, 20}), {0, -0.05, 0}));
            BodyDef def = body(Shape::box({1, 0.5, 1}), {0, 0.8 + 0.1 * k, 0});
            def.velocity = {3, -60, 0};
            def.pose.rotation = turnAboutXyz({0, 0, radians(tilt)});
            const BodyId id = world.add(def);
            EXPECT_GT(lowestCorner(world, id, 20), -0.005) << k << " " << tilt;
        }
}

TEST(FastBox, TumblesOntoTheFloorWithoutSinkingIn) {
    double worst = 0.0;
    for (int k = 0; k < 60; ++k) {
        World world;
        world.add(fixed(Shape::box({40, 1, 40}), {0, -0.5, 0}));
        support::Random random(k);
        BodyDef def = body(Shape::box({1, 0.6, 0.4}), {0, 1.5, 0});
        def.velocity = {3, -10, 0}, def.spin = random.vector(12);
        def.pose.rotation = random.rotation();
        const BodyId id = world.add(def);
        worst = std::min(worst, lowestCorner(world, id, 40));
    }
    EXPECT_GT(worst, -0.03);  // a corner moves 20 cm per step
}

/// A ball through a row of plates: hits, misses and throws.
World shooting(bool ballFirst) {
    World world;
    BodyDef ball = body(Shape::sphere(0.1), {-3, 1, 0.05}, 5.0);
    ball.velocity = {kFast, 3, 1}, ball.spin = {0, 30, 0};
    BodyDef plate = body(Shape::box({0.05, 1, 1}), {0.2, 1.2, 0}, 10.0);
    plate.spin = {1, 2, 0};
    if (ballFirst) world.add(ball), world.add(plate);
    else world.add(plate), world.add(ball);
    return world;
}

TEST(FastBodies, TheOrderOfBodiesDoesNotMatter) {
    World one = shooting(true), other = shooting(false);
    run(one, 10), run(other, 10);
    EXPECT_GT(one.velocity({1}).x(), 10.0);  // it was hit
    for (const int i : {0, 1}) {  // of 200 m/s; they hit twice, which magnifies what the first hit left over
        EXPECT_LT((one.pose({i}).position - other.pose({1 - i}).position).norm(), 0.1);
        EXPECT_LT((one.velocity({i}) - other.velocity({1 - i})).norm(), 0.6);
    }
}

/// Bodies in file, all equally fast, come to a wall: each stops behind the one before, within the step in which that
/// one stops. Returns how deep they overlap, m; infinite if one has passed another.
double overlapInFile(const Settings& settings, const Shape& shape, double length, int count, double gap, double speed) {
    World world(settings);
    world.setGravity({0, 0, 0});
    world.add(fixed(Shape::plane({1, 0, 0})));
    for (int i = 0; i < count; ++i) {
        const double x = 0.137 + 0.5 * length + i * (length + gap);
        BodyDef def = body(shape, {x, 1e-3 * i, 7e-4 * i}, 10.0);
        def.velocity = {-speed, 0, 0};
        world.add(def);
    }
    double deepest = 0.0;
    for (int step = 0; step < 40; ++step) {
        world.step(kStep);
        deepest = std::max(deepest, world.errors().penetration);
    }
    const auto at = [&](int i) { return world.pose({i}).position.x(); };
    for (int i = 2; i <= count; ++i)
        if (at(i) < at(i - 1)) return std::numeric_limits<double>::infinity();
    return deepest;
}

TEST(FastBodies, InFileStopBehindEachOther) {
    const std::pair<Shape, double> all[] = {
        {Shape::sphere(0.1), 0.2}, {Shape::box({0.2, 0.2, 0.2}), 0.2}, {Shape::box({0.05, 0.5, 0.5}), 0.05}};
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const auto& [shape, length] : all)
            for (const int count : {3, 8})
                for (const double gap : {0.01, 0.03, 0.1})
                    for (const double speed : {5.0, 10.0, 20.0})
                        EXPECT_LT(overlapInFile(settings, shape, length, count, gap, speed), 0.2 * length)
                            << settings.substeps << " sub-steps, " << length << " m, " << count << " bodies, gap "
                            << gap << ", " << speed << " m/s";
}

TEST(FastBodies, TheSameThrowGivesTheSameBits) {
    World one = shooting(true), other = shooting(true);
    run(one, 10), run(other, 10);
    EXPECT_EQ(one.hash(), other.hash());
}

// A gap larger than the margin: the first hit throws the second ball at the third.
TEST(FastBodies, ABodyThatIsHitDoesNotEnterItsNeighbour) {
    for (const double gap : {0.03, 0.06, 0.1}) {
        World world = weightless();
        BodyDef ball = body(Shape::box({0.5, 0.5, 0.5}), {-1, 0, 0}, 10.0);
        ball.velocity = {30, 0, 0};
        world.add(ball);
        const BodyId b = world.add(body(Shape::box({0.5, 0.5, 0.5}), {0, 0, 0}, 1.0));
        const BodyId c = world.add(body(Shape::box({0.5, 0.5, 0.5}), {0.5 + gap, 0, 0}, 1.0));
        for (int i = 0; i < 4; ++i) {
            world.step(kStep);
            EXPECT_GT(world.pose(c).position.x() - world.pose(b).position.x(), 0.5 - 0.005) << gap;
        }
    }
}

// Looking at contacts before the first step, as a picture of time 0 does, is no reason to look no farther in it.
TEST(FastBodies, AreSeenInTheFirstStep) {
    for (const double speed : {5.0, 30.0, 100.0}) {
        World world;
        world.setGravity(Vec3::Zero());
        world.add(support::fixed(Shape::box({0.02, 4, 4}), Vec3::Zero()));
        BodyDef def = body(Shape::sphere(0.02), {-0.9 * kStep * speed, 0.013, 0.021});
        def.velocity = {speed, 0, 0};
        const BodyId ball = world.add(def);
        world.findContacts();
        run(world, 30);
        EXPECT_LT(world.pose(ball).position.x(), 0.0) << speed;
    }
}

// A tumbling rod has contacts with both sides of a thin plate; nothing else presses it, so it keeps its own mass.
TEST(FastBodies, ARodThatHitsAHeavyPlateKeepsTheMomentum) {
    support::Random random(5);
    for (int i = 0; i < 20; ++i) {
        World world(i % 2 ? Settings::fast() : Settings::steady());
        world.setGravity(Vec3::Zero());
        const BodyId plate = world.add(body(Shape::box({0.02, 8, 8}), Vec3::Zero(), 1e4));
        BodyDef def = body(Shape::capsule(0.01, 0.1), Vec3(-0.5, 0, 0) + random.vector(0.1), 0.1);
        def.pose.rotation = random.rotation();
        def.velocity = Vec3(5, 0, 0) + random.vector(2.0), def.spin = random.vector(12.0);
        const BodyId rod = world.add(def);
        const Vec3 before = 0.1 * def.velocity;
        const double energy = world.energy().kinetic;
        run(world, 60);
        const Vec3 after = 0.1 * world.velocity(rod) + 1e4 * world.velocity(plate);
        EXPECT_LT((after - before).norm(), 1e-4 * before.norm()) << i;
        EXPECT_LT(world.energy().kinetic, 1.001 * energy) << i;
    }
}

// What stops a ton on a heap of grams must not throw the grams away a sub-step later (solver/fresh_start.h). Once
// they went through the floor in `fast`, and in `steady` a quarter of the ball's energy came back.
TEST(FastBodies, ATonThatFallsOnGramsDoesNotThrowThemAway) {
    for (const Settings& settings : {Settings::fast(), Settings::steady()}) {
        World world(settings);
        world.add(support::floorPlane());
        for (const Vec3& out : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
            world.add(support::fixed(Shape::plane(-out), out));
        support::Random random(77);
        std::vector<BodyId> grams;
        for (int i = 0; i < 60; ++i) {
            const Vec3 at{random.number(-0.8, 0.8), 0.2 + 0.05 * i, random.number(-0.8, 0.8)};  // in this order
            BodyDef gram = body(i % 3 ? Shape::box({0.3, 0.2, 0.25}) : Shape::sphere(0.12), at, 1e-3);
            gram.pose.rotation = random.rotation();
            grams.push_back(world.add(gram));
        }
        BodyDef ton = body(Shape::sphere(0.6), {0, 6, 0}, 1000.0);
        ton.velocity = {0, -20, 0};
        world.add(ton);
        const double start = world.energy().total();
        double least = start;
        for (int i = 0; i < 300; ++i) {
            world.step(kStep);
            least = smaller(least, world.energy().total());
            ASSERT_LT(world.energy().total(), least + 0.02 * start) << "step " << i;
            for (const BodyId id : grams) ASSERT_GT(world.pose(id).position.y(), 0.0) << "step " << i;
        }
    }
}

}  // namespace
}  // namespace engine
