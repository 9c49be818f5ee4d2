// The direct solver: exact for equalities, with an active set for contacts, never NaN.
#include "engine/solver/direct.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/solver/impulses.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

Settings directly() {
    Settings settings = Settings::seed();
    settings.method = Method::direct;
    return settings;
}

/// Ten links and a heavy ball; the hook is body 0.
World chain(const Settings& settings, double ballMass) {
    World world(settings);
    BodyId last = world.add(support::hook());
    for (int i = 0; i < 10; ++i) {
        const double x = 0.5 * i;
        const BodyId next = world.add(
            support::body(Shape::box({0.4, 0.1, 0.1}), {x + 0.25, 0, 0}, i == 9 ? ballMass : 1.0));
        support::join(world, JointType::ball, last, next, {x, 0, 0});
        last = next;
    }
    return world;
}

TEST(Direct, MeetsEveryEquality) {
    Settings settings = directly();
    settings.nudges = 0;
    World world = chain(settings, 1000.0);
    world.step(support::kStep);
    const StepReport& report = world.report();
    EXPECT_EQ(report.direct.rows, 30);
    EXPECT_EQ(report.direct.rank, 30);
    // J v = 0 of every joint: the anchors' relative velocity
    for (int i = 0; i < 10; ++i) {
        const JointState joint = world.joint({i});
        const auto velocityAt = [&](BodyId body, const Vec3& anchor) -> Vec3 {
            return world.velocity(body) +
                   world.spin(body).cross(world.pose(body).rotation * anchor);
        };
        const Vec3 relative =
            velocityAt(joint.def.b, joint.def.anchorB) - velocityAt(joint.def.a, joint.def.anchorA);
        EXPECT_LT(relative.norm(), 1e-3) << i;  // the poses have moved on by one step since
    }
}

TEST(Direct, IsWhatManySweepsComeTo) {
    Settings sweeps = Settings::seed();
    sweeps.sweeps = sweeps.minSweeps = 20'000;
    World exact = chain(directly(), 10.0), swept = chain(sweeps, 10.0);
    exact.step(support::kStep);
    swept.step(support::kStep);
    for (int i = 1; i <= 10; ++i)
        EXPECT_NEAR((exact.velocity({i}) - swept.velocity({i})).norm(), 0.0, 1e-9) << i;
}

/// A box pushed across the floor: the active set finds which corners press and how friction slides.
TEST(Direct, IsWhatManySweepsComeToWithFriction) {
    Settings sweeps = Settings::seed();
    sweeps.sweeps = sweeps.minSweeps = 20'000;
    sweeps.warmStart = false;
    const auto slidingBox = [](const Settings& settings) {
        World world(settings);
        BodyDef floor = support::floorPlane();
        floor.material.friction = 0.3;
        world.add(floor);
        BodyDef box = support::body(Shape::box({1, 1, 1}), {0, 0.4999, 0}, 2.0);
        box.velocity = {3, 0, 1};
        box.material.friction = 0.3;
        world.add(box);
        return world;
    };
    World exact = slidingBox(directly()), swept = slidingBox(sweeps);
    exact.step(support::kStep);
    swept.step(support::kStep);
    EXPECT_TRUE(exact.report().direct.found);
    EXPECT_NEAR((exact.velocity({1}) - swept.velocity({1})).norm(), 0.0, 1e-8);
    EXPECT_NEAR((exact.spin({1}) - swept.spin({1})).norm(), 0.0, 1e-7);
}

TEST(Direct, FiveBoxesPressTheFloorWithTheirWeight) {  // mission 20
    World world = support::stack(5, directly(), 0.6, 2.0);
    support::run(world, 120);
    double impulse = 0.0;
    for (const ContactState& contact : world.contacts())
        if (contact.a.index == 0) impulse += contact.impulse;
    EXPECT_NEAR(impulse / support::kStep, 98.1, 1e-6);
    EXPECT_TRUE(world.report().direct.found);
    EXPECT_LT(world.report().direct.rank, world.report().direct.rows);  // four corners on a plane
}

TEST(Direct, HoldsABodyThatIsOlderThanItsFloor) {
    World world(directly());
    const BodyId box = world.add(support::body(Shape::box({1, 1, 1}), {0, 0.5, 0}));
    world.add(support::floorPlane());
    support::run(world, 60);
    EXPECT_NEAR(world.pose(box).position.y(), 0.5, 1e-3);
}

TEST(Direct, NamesRedundantJointsAndStaysFinite) {
    World world(directly());
    const BodyId hook = world.add(support::hook());
    const BodyId ball = world.add(support::body(Shape::sphere(0.1), {0, -1, 0}));
    support::join(world, JointType::ball, hook, ball, {0, 0, 0});
    support::join(world, JointType::ball, hook, ball, {0, 0, 0});  // the same joint again
    support::run(world, 60);
    const DirectReport& direct = world.report().direct;
    EXPECT_EQ(direct.rows, 6);
    EXPECT_EQ(direct.rank, 3);
    EXPECT_FALSE(direct.contradiction);
    ASSERT_EQ(direct.redundant.size(), 1u);
    EXPECT_TRUE(world.pose(ball).position.allFinite());
    // Both joints carry half of the weight.
    EXPECT_NEAR(world.joint({0}).force.y() + world.joint({1}).force.y(), 9.81, 1e-3);
    EXPECT_NEAR(world.joint({0}).force.y(), world.joint({1}).force.y(), 1e-6);
}

TEST(Direct, ContradictingJointsAreMetAsNearlyAsPossible) {
    Settings settings = directly();
    settings.nudges = 0;
    settings.baumgarte = 0.2;
    World world(settings);
    world.setGravity(Vec3::Zero());
    const BodyId left = world.add(support::hook({-1, 0, 0}));
    const BodyId right = world.add(support::hook({1, 0, 0}));
    const BodyId point = world.add(support::body(Shape::sphere(0.1), {0.5, 0, 0}));
    for (const BodyId hook : {left, right}) {
        JointDef def;
        def.a = hook, def.b = point;
        world.add(def);
    }
    support::run(world, 300);
    EXPECT_TRUE(world.report().direct.contradiction);
    EXPECT_NEAR(world.pose(point).position.x(), 0.0, 1e-6);  // half way: least squares
}

TEST(Direct, RefusesTooManyRowsInOneIsland) {
    World tall = support::stack(90, directly());  // 90 * 12 rows
    EXPECT_FALSE(tall.step(support::kStep));
    EXPECT_EQ(tall.report().trouble, Trouble::tooManyRows);
    World apart(directly());  // as many, but every box is an island
    apart.add(support::floorPlane());
    for (int i = 0; i < 90; ++i)
        apart.add(support::body(Shape::box({1, 1, 1}), {1.5 * i, 0.5, 0}));
    EXPECT_TRUE(apart.step(support::kStep));
}

TEST(Direct, IsTheMeasureOfEverySweep) {
    Settings settings = Settings::seed();
    settings.compareExact = true;
    settings.sweeps = settings.minSweeps = 40;
    settings.warmStart = false;
    World world = chain(settings, 10.0);
    world.step(support::kStep);
    const std::vector<SweepReport>& sweeps = world.report().sweeps;
    ASSERT_EQ(sweeps.size(), 40u);
    EXPECT_GT(sweeps[0].distance, 0.0);
    EXPECT_LT(sweeps[39].distance, sweeps[0].distance);
    settings.method = Method::direct;
    World exact = chain(settings, 10.0);
    exact.step(support::kStep);
    EXPECT_EQ(exact.report().sweeps.at(0).distance, 0.0);
}

// Balls that land one on the other do not turn: only their linear velocities differ.
TEST(Direct, MeasuresBodiesThatDoNotTurn) {
    Settings settings = Settings::seed();
    settings.compareExact = true;
    settings.sweeps = settings.minSweeps = 1;
    World world(settings);
    world.add(support::floorPlane());
    for (const double height : {0.5, 1.5})
        world.add(support::body(Shape::sphere(0.5), {0, height, 0})), world.setVelocity({world.bodyCount() - 1}, {0, -1, 0}, {0, 0, 0});
    world.step(support::kStep);
    EXPECT_GT(world.report().sweeps.at(0).distance, 0.01);
}

/// Rows that push between random points of eight bodies, in random directions.
struct RandomRows {
    support::Random random;
    Bodies bodies;
    GlobalRows g;

    RandomRows(int count, std::uint64_t seed) : random(seed) {
        addBody(bodies, support::hook(), 0);
        for (int i = 1; i < 8; ++i) addBody(bodies, support::body(Shape::sphere(0.5), {0, 0, 0}, random.number(0.2, 5)), i);
        g.h = support::kStep;
        for (int i = 0; i < count; ++i) add(i % 7 + 1, (i * i + 3 * i) % 8);
    }
    void add(int a, int b) {
        GlobalRow row;
        row.a = a, row.b = a == b ? 0 : b, row.kind = RowKind::push;
        row.row = makeRow(alongDirection(random.vector(1).normalized(), random.vector(0.5), random.vector(0.5)),
                          bodies.inverseMasses[row.a], bodies.inverseMasses[row.b]);
        g.rows.push_back(row), g.wanted.push_back(random.number(-5, 5)), g.force.push_back(0.0);
    }
};

// lambda >= 0, A lambda - wanted >= 0, and one of the two is 0; whatever the number of changes to the active set.
TEST(Direct, FindsTheActiveSetOfRandomRows) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        RandomRows r(28, seed);
        const auto report = solveDirect(r.g, {}, r.bodies.count());
        ASSERT_TRUE(report);
        EXPECT_TRUE(report->found) << seed;
        std::vector<Velocity> a(r.bodies.count());
        addAlongRows(r.g, r.g.force, a);
        for (int i = 0; i < r.g.count(); ++i) {
            const double slack = velocityAlong(r.g.rows[i].row.j, a[r.g.rows[i].a], a[r.g.rows[i].b]) - r.g.wanted[i];
            EXPECT_GE(r.g.force[i], -1e-8) << seed;
            EXPECT_GE(slack, -1e-8) << seed;
            EXPECT_LT(smaller(r.g.force[i], slack), 1e-8) << seed;
        }
    }
}

// The last row is a moment on bodies that cannot turn.
TEST(Direct, LeavesARowThatNothingCanMoveWithoutAForce) {
    RandomRows r(6, 1);
    const InverseMass stiff{1.0, Mat3::Zero()};
    r.g.rows[5].row = makeRow({Vec3::Zero(), -Vec3::UnitX(), Vec3::UnitX()}, stiff, stiff);
    r.g.wanted[5] = 3.0;
    const auto report = solveDirect(r.g, {}, r.bodies.count());
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->found);
    EXPECT_EQ(r.g.force[5], 0.0);
    EXPECT_GT(*std::ranges::max_element(r.g.force), 0.0);
}

}  // namespace
}  // namespace engine
