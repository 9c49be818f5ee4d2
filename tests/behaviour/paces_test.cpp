// solver/paces.h: an island gets as many sub-steps as it needs, without affecting others.
#include <gtest/gtest.h>

#include <numbers>

#include "engine/base/hash.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::join;
using support::kStep;
using support::run;

enum class Beside { nothing, heavyOnLight, column, fastWheel, motor, columnBefore };

/// One or more bodies far from the pyramid that need more sub-steps than it does.
void addBeside(World& world, Beside what) {
    const Vec3 at{40, 0, 0};
    if (what == Beside::heavyOnLight) {
        world.add(body(Shape::box({1, 1, 1}), at + Vec3(0, 0.5, 0), 1.0));
        world.add(body(Shape::box({1, 1, 1}), at + Vec3(0, 1.5, 0), 100.0));
    }
    const bool column = what == Beside::column || what == Beside::columnBefore;
    for (int i = 0; column && i < 20; ++i)
        world.add(body(Shape::box({1, 1, 1}), at + Vec3(0, i + 0.5, 0), 1.0));
    if (what != Beside::fastWheel && what != Beside::motor) return;
    const BodyId axle = world.add(support::hook(at + Vec3(0, 3, 0)));
    BodyDef wheel = body(Shape::cylinder(1.0, 0.2), at + Vec3(0, 3, 0), 5.0);
    wheel.pose.rotation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
    if (what == Beside::fastWheel) wheel.spin = {0, 0, 60};
    const JointId hinge = join(world, JointType::hinge, axle, world.add(wheel), at + Vec3(0, 3, 0));
    Freedom driven;
    driven.motor = Motor{60.0, 1e3};
    if (what == Beside::motor) world.setFreedom(hinge, 0, driven);
}

struct Outcome {
    std::uint64_t hash = 0;  // of the pyramid's bodies
    int mostSubsteps = 0;
};

Outcome pyramidBeside(Beside what, Settings settings, bool lanes) {
    settings.lanes = lanes;
    World world(settings);
    world.add(support::floorPlane());
    if (what == Beside::columnBefore) addBeside(world, what);  // lower numbers
    const int first = world.bodyCount();
    constexpr int kRows = 9;  // more than 64 contacts: its own group
    for (int row = 0; row < kRows; ++row)
        for (int i = 0; i < kRows - row; ++i)
            world.add(body(Shape::box({1, 1, 1}), {1.05 * (i + 0.5 * row), row + 0.52, 0}));
    const int count = world.bodyCount();
    if (what != Beside::columnBefore) addBeside(world, what);
    Outcome outcome;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        outcome.mostSubsteps = larger(outcome.mostSubsteps, world.report().substeps);
    }
    StateHash hash;
    for (int i = first; i < count; ++i) {
        hash.add(world.pose({i}).position), hash.add(world.pose({i}).rotation);
        hash.add(world.velocity({i})), hash.add(world.spin({i}));
    }
    outcome.hash = hash.value();
    return outcome;
}

class PyramidInLanes : public testing::TestWithParam<bool> {};

TEST_P(PyramidInLanes, IsTheSameToTheBitWhateverIsBesideIt) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        const Outcome alone = pyramidBeside(Beside::nothing, settings, GetParam());
        EXPECT_EQ(alone.mostSubsteps, settings.substeps);
        for (const Beside what :
             {Beside::heavyOnLight, Beside::column, Beside::fastWheel, Beside::motor,
              Beside::columnBefore}) {
            const Outcome beside = pyramidBeside(what, settings, GetParam());
            EXPECT_GT(beside.mostSubsteps, settings.substeps) << static_cast<int>(what);
            EXPECT_EQ(beside.hash, alone.hash) << static_cast<int>(what);
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Paces, PyramidInLanes, testing::Bool(), [](const auto& lanes) {
    return lanes.param ? "lanes" : "rows";
});

/// Two rods that spin about each other and drift towards boxes in a row, without gravity.
World rodsAndBoxes(bool lanes) {
    Settings settings;
    settings.lanes = lanes;
    World world(settings);
    world.setGravity(Vec3::Zero());
    BodyDef rod = body(Shape::box({0.8, 0.1, 0.1}), {-2.0, 0, 0}, 2.0);
    rod.velocity = {2.0, 0, 0};
    rod.spin = {0, 0, 25};
    rod.material.restitution = 0.0;
    const BodyId a = world.add(rod);
    rod.pose.position.x() -= 0.8;
    rod.velocity.y() -= 25 * 0.8;
    const BodyId b = world.add(rod);
    join(world, JointType::ball, a, b, {-2.4, 0, 0});
    for (int i = 0; i < 5; ++i)
        world.add(body(Shape::box({0.5, 0.5, 0.5}), {0.3 + 0.5 * i, 0, 0}, 1.0));
    return world;
}

Vec3 momentumOf(const World& world) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < world.bodyCount(); ++i) sum += world.mass({i}) * world.velocity({i});
    return sum;
}

// Islands of different strides meet: momentum is conserved, and energy does not grow.
TEST(Paces, IslandsThatMeetKeepMomentumAndGainNoEnergy) {
    for (const bool lanes : {true, false}) {
        World world = rodsAndBoxes(lanes);
        run(world, 1);
        const Vec3 before = momentumOf(world);
        double most = world.energy().total();
        bool met = false;
        for (int i = 0; i < 300; ++i) {
            const double energy = world.energy().total();
            world.step(kStep);
            met = met || !world.contacts().empty();
            EXPECT_LT(world.energy().total(), energy + 1e-3 * most) << i << " lanes " << lanes;
        }
        EXPECT_TRUE(met);
        EXPECT_LT((momentumOf(world) - before).norm(), 1e-5 * before.norm()) << "lanes " << lanes;
    }
}

// A ball falls onto a column with another stride and rests there.
TEST(Paces, ABallThatLandsOnAColumnRestsOnIt) {
    World world = support::stack(14, Settings::steady(), 0.6, 1.0);
    BodyDef box = body(Shape::box({0.5, 0.5, 0.5}), {0, 16.0, 0});
    box.material.restitution = 0.0;
    const BodyId dropped = world.add(box);
    run(world, 600);
    EXPECT_NEAR(world.pose(dropped).position.y(), 14.25, 5e-3);
    EXPECT_LT(world.velocity(dropped).norm(), 1e-3);
}

// A body that acts in every sub-step makes those it carries do so too: a lift under a pile, next to
// a wheel.
TEST(Paces, ALiftCarriesItsPileBesideAFastWheel) {
    World world;
    BodyDef lift = support::fixed(Shape::box({4, 0.2, 4}), {0, 0, 0});
    lift.kind = BodyKind::kinematic;
    lift.velocity = {0, 2.0, 0};
    world.add(lift);
    for (int i = 0; i < 4; ++i) world.add(body(Shape::box({1, 1, 1}), {0, 0.6 + i, 0}));
    addBeside(world, Beside::fastWheel);
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        EXPECT_LT(world.errors().penetration, 2e-3);
    }
    EXPECT_NEAR(world.pose({4}).position.y() - world.pose({0}).position.y(), 3.6, 5e-3);
}

int substepsOfTwo(double below, double above) {
    World world(Settings::fast());
    world.add(support::floorPlane());
    world.add(body(Shape::box({1, 1, 1}), {0, 0.5, 0}, below));
    world.add(body(Shape::box({1, 1, 1}), {0, 1.5, 0}, above));
    run(world, 2);
    return world.report().substeps;
}

TEST(LoadRatio, CountsIfTheHeavyOneIsAbove) {
    EXPECT_EQ(substepsOfTwo(1, 9), 2);
    EXPECT_EQ(substepsOfTwo(1, 20), 4);
    EXPECT_EQ(substepsOfTwo(1, 60), 8);
    EXPECT_EQ(substepsOfTwo(20, 1), 2);
    EXPECT_EQ(substepsOfTwo(1000, 1), 2);
}

/// A box with a wheel that turns at 30 rad/s.
int substepsOfWheel(double height) {
    World world(Settings::fast());
    world.add(support::floorPlane());
    const BodyId box = world.add(body(Shape::box({2, 1, 2}), {0, height + 0.5, 0}, 5.0));
    BodyDef wheel = body(Shape::cylinder(0.5, 0.2), {0, height + 2, 0});
    wheel.spin = {0, 30, 0};
    join(world, JointType::hinge, box, world.add(wheel), {0, height + 1, 0}, Vec3::UnitY());
    run(world, 2);
    return world.report().substeps;
}

TEST(Turns, NeedFewerSubstepsInAnIslandThatTouches) {
    EXPECT_EQ(substepsOfWheel(10), 6);
    EXPECT_EQ(substepsOfWheel(0), 2);
}

}  // namespace
}  // namespace engine
