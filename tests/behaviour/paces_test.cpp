// solver/paces.h: an island gets as many sub-steps as it needs, without affecting others.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/joints.h"

namespace engine {
namespace {

using support::body;
using support::join;
using support::kStep;
using support::run;

enum class Beside {
    nothing, heavyOnLight, column, fastWheel, motor, fastBall, tumblingDie, contradiction, columnBefore
};

void addCagedBall(World& world, const Vec3& at) {  // in a box
    for (int k = 0; k < 6; ++k) {
        Vec3 out = Vec3::Zero();
        out[k / 2] = k % 2 == 0 ? 1 : -1;
        BodyDef wall = support::fixed(Shape::box(Vec3(12, 12, 12) - 10 * out.cwiseAbs()), at + 6 * out);
        wall.material.restitution = 1.0;
        world.add(wall);
    }
    BodyDef ball = body(Shape::sphere(0.3), at, 1.0);
    ball.velocity = {250, 40, 70};
    ball.material.restitution = 1.0;
    world.add(ball);
}

/// One or more bodies, far from the others, that need more sub-steps, sweeps or contact detections than these do: a
/// power of two, in which others find their own number.
void addBeside(World& world, Beside what) {
    const Vec3 at{40, 0, 0};
    if (what == Beside::heavyOnLight) {
        world.add(body(Shape::box({1, 1, 1}), at + Vec3(0, 0.5, 0), 1.0));
        world.add(body(Shape::box({1, 1, 1}), at + Vec3(0, 1.5, 0), 100.0));
    }
    const bool column = what == Beside::column || what == Beside::columnBefore;
    const int levels = world.settings().substeps > 2 ? 20 : 12;
    for (int i = 0; column && i < levels; ++i)
        world.add(body(Shape::box({1, 1, 1}), at + Vec3(0, i + 0.5, 0), 1.0));
    if (what == Beside::fastBall) addCagedBall(world, at + Vec3(20, 8, 0));
    if (what == Beside::tumblingDie) {  // on an edge, so that it turns in contact
        BodyDef die = body(Shape::box({0.3, 0.3, 0.3}), at + Vec3(0, 0.2, 0), 1.0);
        die.spin = {30, 0, 45};
        world.add(die);
    }
    if (what == Beside::contradiction) {
        const BodyId hook = world.add(support::hook(at));
        const BodyId box = world.add(body(Shape::box({1, 1, 1}), at + Vec3(0, 2, 0)));
        join(world, JointType::weld, hook, box, at);
        join(world, JointType::weld, hook, box, at + Vec3(0.3, 0, 0));
        world.setPose(box, support::at(at + Vec3(0.5, 2, 0)));
    }
    if (what != Beside::fastWheel && what != Beside::motor) return;
    const BodyId axle = world.add(support::hook(at + Vec3(0, 3, 0)));
    BodyDef wheel = body(Shape::cylinder(1.0, 0.2), at + Vec3(0, 3, 0), 5.0);
    wheel.pose.rotation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
    if (what == Beside::fastWheel) wheel.spin = {0, 0, 45};
    const JointId hinge = join(world, JointType::hinge, axle, world.add(wheel), at + Vec3(0, 3, 0));
    Freedom driven;
    driven.motor = Motor{45.0, 1e3};
    if (what == Beside::motor) world.setFreedom(hinge, 0, driven);
}

enum class Main { pyramid, chains, limits, net, ragdoll, dragged, springs, turntable, rolling };

void addWidePyramid(World& world) {
    constexpr int kRows = 9;  // more than 64 contacts: its own group
    for (int row = 0; row < kRows; ++row)
        for (int i = 0; i < kRows - row; ++i)
            world.add(body(Shape::box({1, 1, 1}), {1.05 * (i + 0.5 * row), row + 0.52, 0}));
}

void addHungChain(World& world, const Vec3& at, int links, const Limits& limits = {}) {
    BodyId last = world.add(support::hook(at));
    for (int i = 0; i < links; ++i) {
        BodyDef link = body(Shape::box({0.5, 0.1, 0.1}), at + Vec3(0.25 + 0.5 * i, 0, 0));
        link.collide = false;
        const BodyId next = world.add(link);
        const JointId joint = join(world, JointType::hinge, last, next, at + Vec3(0.5 * i, 0, 0));
        Freedom limited;
        limited.limits = limits;
        world.setFreedom(joint, 0, limited);
        last = next;
    }
}

void addHungNet(World& world) {
    constexpr int kSize = 5;
    std::vector<BodyId> knots;
    for (int k = 0; k < kSize * kSize; ++k) {
        const Vec3 at(0.3 * (k / kSize), 5, 0.3 * (k % kSize));
        BodyDef knot = k < kSize ? support::hook(at) : body(Shape::sphere(0.05), at, 0.1);
        knot.collide = false;
        knots.push_back(world.add(knot));
        if (k >= kSize) support::rod(world, knots[k - kSize], knots[k]);
        if (k >= kSize && k % kSize > 0) support::rod(world, knots[k - 1], knots[k]);
    }
}

/// A trunk with four limbs, which falls on the floor.
void addLimbs(World& world) {
    const BodyId trunk = world.add(body(Shape::capsule(0.15, 0.5), {0, 1, 0}, 10));
    for (int i = 0; i < 4; ++i) {
        const double side = i % 2 == 0 ? -1 : 1;
        const Vec3 at(0.25 * side, i < 2 ? 1.3 : 0.6, 0);
        BodyDef limb = body(Shape::capsule(0.07, 0.3), at + Vec3(0.3 * side, 0, 0), 2);
        limb.pose.rotation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
        engine::JointDef joint = support::jointAt(world, JointType::ball, trunk, world.add(limb), at, Vec3::UnitX());
        joint.free[0].limits = {-0.5, 0.5}, joint.free[1].limits = {0, 0.8};
        world.add(joint);
    }
}

void addForcedBoxes(World& world, bool springs) {
    std::vector<BodyId> bodies;
    for (int i = 0; i < 6; ++i)
        bodies.push_back(world.add(body(Shape::box({0.5, 0.5, 0.5}), {1.0 * i, 0.25 + 0.1 * i, 0})));
    if (!springs) world.add(ForceDef{Drag{0.5, 0.5}, bodies});
    for (int i = 1; springs && i < 6; ++i)
        world.add(ForceDef{SpringForce{Vec3::Zero(), Vec3::Zero(), 0.8, 50.0, 0.5}, {bodies[i - 1], bodies[i]}});
}

void addLoadedTurntable(World& world) {
    BodyDef table = support::fixed(Shape::cylinder(3, 0.2), {0, 0.5, 0});
    table.kind = BodyKind::kinematic;
    table.spin = {0, 1, 0};
    world.add(table);
    for (int i = 0; i < 4; ++i)
        world.add(body(Shape::box({0.5, 0.5, 0.5}), {2.0 * std::cos(i), 0.85, 2.0 * std::sin(i)}));
}

/// Balls, and a cylinder, that roll at up to 3 m/s and hit the floor obliquely.
void addRolling(World& world) {
    for (const double speed : {0.5, 1.0, 3.0}) {
        BodyDef ball = body(Shape::sphere(0.1), {0, 0.1, speed}, 1.0);
        ball.velocity = {speed, 0, 0}, ball.spin = {0, 0, -10 * speed};
        world.add(ball);
        ball.shape = Shape::cylinder(0.1, 0.2);
        ball.pose.position.z() += 4;
        ball.pose.rotation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
        world.add(ball);
        BodyDef thrown = body(Shape::sphere(0.1), {0, 0.5 + 0.07 * speed, -speed}, 1.0);
        thrown.velocity = {2 * speed, -speed, 0};
        world.add(thrown);
    }
}

void addMainIsland(World& world, Main what) {
    if (what == Main::rolling) addRolling(world);
    if (what == Main::pyramid) addWidePyramid(world);
    if (what == Main::chains)
        for (int i = 0; i < 3; ++i) addHungChain(world, {0, 5, 1.0 * i}, 2 + i);
    if (what == Main::limits) addHungChain(world, {0, 5, 0}, 2, {-0.5, 0.5});
    if (what == Main::net) addHungNet(world);
    if (what == Main::ragdoll) addLimbs(world);
    if (what == Main::dragged || what == Main::springs) addForcedBoxes(world, what == Main::springs);
    if (what == Main::turntable) addLoadedTurntable(world);
}

struct Outcome {
    std::vector<Vec3> places, velocities;  // of the main bodies
    int mostSubsteps = 0;

    /// The largest sum of the differences of place and velocity, m and m/s.
    double distance(const Outcome& other) const {
        double most = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i)
            most = larger(most, (places[i] - other.places[i]).norm() + (velocities[i] - other.velocities[i]).norm());
        return most;
    }
};

Outcome mainBeside(Main main, Beside what, Settings settings, bool lanes) {
    settings.lanes = lanes;
    World world(settings);
    world.add(support::floorPlane());
    if (what == Beside::columnBefore) addBeside(world, what);  // lower numbers
    const int first = world.bodyCount();
    addMainIsland(world, main);
    const int count = world.bodyCount();
    if (what != Beside::columnBefore) addBeside(world, what);
    Outcome outcome;
    for (int i = 0; i < 90; ++i) {
        world.step(kStep);
        outcome.mostSubsteps = larger(outcome.mostSubsteps, world.report().substeps);
    }
    for (int i = first; i < count; ++i)
        outcome.places.push_back(world.pose({i}).position), outcome.velocities.push_back(world.velocity({i}));
    return outcome;
}

/// m and m/s. The impulses of kept contacts are rounded when others look for theirs. Islands with few contacts, and
/// driven trees, are swept together.
double allowed(Main main, Beside what, bool lanes) {
    if (what == Beside::fastBall) return lanes ? 1e-3 : 1e-9;
    if (what == Beside::tumblingDie) return 5e-3;
    return main == Main::limits || main == Main::ragdoll ? 1e-9 : 0.0;
}

std::string nameOfMain(const testing::TestParamInfo<std::tuple<Main, bool>>& one) {
    constexpr const char* kNames[] = {"pyramid", "chains",  "limits",  "net",
                                      "ragdoll", "dragged", "springs", "turntable", "rolling"};
    return std::string(kNames[static_cast<int>(std::get<0>(one.param))]) +
           (std::get<1>(one.param) ? "InLanes" : "InRows");
}

class MainIsland : public testing::TestWithParam<std::tuple<Main, bool>> {};

TEST_P(MainIsland, IsTheSameWhateverIsBesideIt) {
    const auto [main, lanes] = GetParam();
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        const Outcome alone = mainBeside(main, Beside::nothing, settings, lanes);
        for (const Beside what : {Beside::heavyOnLight, Beside::column, Beside::fastWheel, Beside::motor,
                                  Beside::fastBall, Beside::tumblingDie, Beside::contradiction,
                                  Beside::columnBefore}) {
            const Outcome beside = mainBeside(main, what, settings, lanes);
            if (what != Beside::contradiction && what != Beside::tumblingDie) {
                EXPECT_GT(beside.mostSubsteps, settings.substeps) << static_cast<int>(what);
            }
            EXPECT_LE(beside.distance(alone), allowed(main, what, lanes)) << static_cast<int>(what);
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Paces, MainIsland,
                         testing::Combine(testing::Values(Main::pyramid, Main::chains, Main::limits, Main::net,
                                                          Main::ragdoll, Main::dragged, Main::springs,
                                                          Main::turntable, Main::rolling),
                                          testing::Bool()),
                         nameOfMain);

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

// A spring pulls spinning rods towards a kinematic body that needs fewer sub-steps: as if all took every one.
TEST(Paces, ASpringSeesAKinematicBodyAtItsOwnTime) {
    const auto placeOfRod = [](bool every) {
        World world = rodsAndBoxes(true);
        BodyDef hand = support::fixed(Shape::sphere(0.1), {-2, 3, 0});
        hand.kind = BodyKind::kinematic;
        hand.velocity = {-4, 1, 0};
        world.add(ForceDef{SpringForce{Vec3::Zero(), Vec3::Zero(), 1.0, 50.0, 0.0}, {world.add(hand), {0}}});
        if (every) world.setForceField([](const World&, std::span<Load>) {});
        run(world, 20);
        EXPECT_GT(world.report().substeps, world.settings().substeps);
        return world.pose({0}).position;
    };
    EXPECT_EQ(placeOfRod(true), placeOfRod(false));
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

// A kinematic body acts as often as those it carries: a lift under a pile, next to a wheel.
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

/// On a hundredth or less, more for every level.
TEST(LoadRatio, CountsTheLevelsBelowAVeryHeavyOne) {
    for (const int levels : {2, 4, 6}) {
        World world(Settings::fast());
        world.add(support::floorPlane());
        for (int i = 0; i <= levels; ++i)
            world.add(body(Shape::box({1, 1, 1}), {0, i + 0.5, 0}, i < levels ? 1.0 : 1000.0));
        run(world, 2);
        EXPECT_EQ(world.report().substeps, levels == 2 ? 12 : levels == 4 ? 16 : 24) << levels;
    }
}

// The balls at its ends do not spin.
TEST(Turns, OfARodNeedSubsteps) {
    const auto substepsAt = [](double rate) {
        World world(Settings::fast());
        world.setGravity(Vec3::Zero());
        BodyDef ends[2] = {body(Shape::sphere(0.1), {-0.5, 0, 0}), body(Shape::sphere(0.1), {0.5, 0, 0})};
        ends[0].velocity = {0, -0.5 * rate, 0}, ends[1].velocity = {0, 0.5 * rate, 0};
        const BodyId a = world.add(ends[0]), b = world.add(ends[1]);
        support::rod(world, a, b);
        run(world, 1);
        return world.report().substeps;
    };
    EXPECT_LE(substepsAt(6), 2);
    EXPECT_GE(substepsAt(60), 10);
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
