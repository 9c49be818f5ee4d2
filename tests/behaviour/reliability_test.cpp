// Non-finite states do not spread, and badly built scenes do no harm.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/support/joints.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kStep;
using support::run;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

TEST(Trouble, ABodyThatIsPushedByNoNumberIsTakenOutAndTheRestGoesOn) {
    World world = support::stack(3), other = support::stack(3);
    run(world, 10);
    run(other, 10);
    const Vec3 place = world.pose({3}).position;
    world.applyForce({3}, {kNoNumber, 0, 0});
    other.remove(BodyId{3});
    for (World* w : {&world, &other}) ASSERT_TRUE(w->step(kStep));
    ASSERT_EQ(world.report().incidents.size(), 1u);
    EXPECT_EQ(world.report().incidents[0].body, BodyId{3});
    EXPECT_EQ(world.report().incidents[0].trouble, Trouble::positionNotFinite);
    EXPECT_FALSE(world.has(BodyId{3}));
    EXPECT_EQ(world.pose({3}).position, place);
    EXPECT_EQ(world.report().step, 11);
    run(world, 100);
    EXPECT_TRUE(world.report().incidents.empty());
    for (const BodyId id : {BodyId{1}, BodyId{2}})
        EXPECT_LT((world.pose(id).position - Vec3(0, id.index - 0.5, 0)).norm(), 2e-3);
}

TEST(Trouble, AForceFieldWithoutANumberTakesItsBodyOutAndNoOther) {
    World world = support::stack(2);
    const BodyId left = world.add(body(Shape::sphere(0.5), {20, 5, 0}));
    const BodyId right = world.add(body(Shape::sphere(0.5), {22, 5, 0}));
    support::rod(world, left, right);
    world.setForceField([&](const World& w, std::span<engine::Load> loads) {
        if (w.report().step == 5 && w.has(left)) loads[left.index].force.x() = kNoNumber;
    });
    run(world, 60);
    EXPECT_FALSE(world.has(left));
    EXPECT_TRUE(world.has(right));
    EXPECT_EQ(world.report().step, 60);
    EXPECT_LT((world.pose({2}).position - Vec3(0, 1.5, 0)).norm(), 2e-3);
}

/// Every two bodies touch: the contacts grow with the square of the number.
World heapAtAPoint(int bodies, int threads) {
    Settings settings;
    settings.threads = threads;
    World world(settings);
    for (int i = 0; i < bodies; ++i) world.add(body(Shape::sphere(0.5), {0.001 * i, 0, 0}));
    return world;
}

TEST(Trouble, TooManyContactsAreNotBegun) {
    for (const int bodies : {700, 5000})  // too many contacts; too many pairs
        for (const int threads : {1, 2}) {
            World world = heapAtAPoint(bodies, threads);
            EXPECT_FALSE(world.step(kStep)) << bodies;
            EXPECT_EQ(world.report().trouble, Trouble::tooManyContacts);
            EXPECT_EQ(world.report().step, 0);
            EXPECT_EQ(world.pose({1}).position, Vec3(0.001, 0, 0));
            EXPECT_TRUE(world.contacts().empty());
        }
}

/// Triangles between corners at random in a cube of 1 m.
Shape soup(int triangles) {
    support::Random random(7);
    std::vector<Vec3> corners;
    for (int i = 0; i < 1000; ++i) corners.push_back(random.vector(0.5));
    std::vector<std::array<int, 3>> faces;
    for (int i = 0; i < triangles; ++i) faces.push_back({i % 1000, (7 * i + i / 1000) % 1000, (31 * i + 500) % 1000});
    return Shape::meshOf(corners, faces);
}

TEST(Trouble, ABodyDeepInAFineMeshIsTooMuch) {
    for (const int triangles : {2000, 50'000}) {
        World world;
        BodyDef ground = body(soup(triangles), {0, 0, 0});
        ground.kind = BodyKind::fixed;
        world.add(ground);
        world.add(body(Shape::box({1, 1, 1}), {0.01, 0, 0}));
        const bool fits = triangles == 2000;
        EXPECT_EQ(world.step(kStep), fits) << triangles;
        EXPECT_EQ(world.report().trouble, fits ? Trouble::none : Trouble::tooManyContacts);
    }
}

// Ahead of it are thousands of triangles, each with a normal of its own.
TEST(Trouble, AFastBallOnRoughGroundIsNone) {
    support::Random random(7);
    std::vector<double> heights(160 * 160);
    for (double& height : heights) height = random.number(-0.03, 0.03);
    World world;
    BodyDef ground = body(Shape::heightField(160, 160, 0.05, heights), {0, 0, 0});
    ground.kind = BodyKind::fixed;
    world.add(ground);
    BodyDef ball = body(Shape::sphere(1.5), {-2, 1.6, 0});
    ball.velocity = {30, -60, 0};
    world.add(ball);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(world.step(kStep)) << i;
}

/// A mesh in a corner of the bounds of balls, where no ball reaches.
TEST(Trouble, TooManyTrianglesAreNotLookedAt) {
    for (const int balls : {50, 205})
        for (const int threads : {1, 2}) {
            Settings settings;
            settings.threads = threads;
            World world(settings);
            std::vector<double> flat(101 * 101, 0.0);
            BodyDef ground = body(Shape::heightField(101, 101, 0.001, flat), {0.9, 0.9, 0.9});
            ground.kind = BodyKind::fixed;
            world.add(ground);
            for (int i = 0; i < balls; ++i) world.add(body(Shape::sphere(1.0), {0, 0, 0}));
            EXPECT_EQ(world.step(kStep), balls == 50) << balls;
        }
}

// Bodies that are taken out before the first step are no trouble.
TEST(Trouble, ACrowdThatIsGoneIsNone) {
    World world = heapAtAPoint(5000, 1);
    world.findContacts();
    EXPECT_TRUE(world.contacts().empty());
    for (int i = 2; i < 5000; ++i) world.remove(BodyId{i});
    EXPECT_TRUE(world.step(kStep));
    EXPECT_EQ(world.errors().contacts, 1);
}

TEST(Trouble, ABodyThatIsTooFastIsSlowedDownAndNamed) {
    World world;
    world.add(body(Shape::sphere(1), Vec3::Zero()));
    const BodyId fast = world.add(body(Shape::sphere(1), {10, 0, 0}));
    world.setVelocity(fast, {2e4, 0, 0}, Vec3::Zero());
    EXPECT_TRUE(world.step(kStep));
    ASSERT_EQ(world.report().incidents.size(), 1u);
    EXPECT_EQ(world.report().incidents[0].trouble, Trouble::velocityTooLarge);
    EXPECT_EQ(world.report().incidents[0].body, fast);
    EXPECT_DOUBLE_EQ(world.velocity(fast).x(), 1e4);
}

/// Four links on a floor, joined by balls.
std::vector<BodyId> chainOnAFloor(World& world) {
    world.add(support::floorPlane());
    std::vector<BodyId> links;
    for (int i = 0; i < 4; ++i) {
        links.push_back(world.add(body(Shape::box({1, 0.2, 0.2}), {1.0 * i, 0.1, 0}, 0.5)));
        if (i > 0) support::join(world, JointType::ball, links[i - 1], links[i], {i - 0.5, 0.1, 0});
    }
    return links;
}

TEST(Trouble, AnEnormousLoadOnOneLinkLosesNoOtherLink) {
    const std::function<void(World&, BodyId, double)> loads[] = {
        [](World& w, BodyId link, double size) { w.applyForce(link, {0.6 * size, 0.8 * size, 0}); },
        [](World& w, BodyId link, double size) {
            w.applyForce(link, Vec3::Zero(), {0.6 * size, 0, 0.8 * size});
        },
        [](World& w, BodyId link, double size) { w.applyImpulse(link, {size, 0, 0}, {0, 0.2, 0}); },
        [](World& w, BodyId link, double size) { w.setVelocity(link, {size, 0, 0}, {0, size, 0}); }};
    for (const auto& load : loads)
        for (const double size : {1e12, 1e20, 1e40, 1e100, 1e200, 1e308, kNoNumber}) {
            World world;
            const std::vector<BodyId> links = chainOnAFloor(world);
            run(world, 10);
            load(world, links[1], size);
            EXPECT_TRUE(world.step(kStep)) << size;
            EXPECT_FALSE(world.report().incidents.empty()) << size;
            for (const int i : {0, 2, 3}) EXPECT_TRUE(world.has(links[i])) << size << ", " << i;
        }
}

TEST(Trouble, ABodyThatSpinsTooFastIsSlowedDownAndItsNeighboursDoNotNotice) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world = support::stack(3, settings), alone = support::stack(3, settings);
        const BodyDef def = body(Shape::box({1, 0.3, 0.2}), {10, 500, 0});
        const BodyId fast = world.add(def);
        alone.add(def);
        world.setVelocity(fast, Vec3::Zero(), {1e3, 3e4, 1e3});
        EXPECT_TRUE(world.step(kStep));
        ASSERT_EQ(world.report().incidents.size(), 1u);
        EXPECT_EQ(world.report().incidents[0].body, fast);
        EXPECT_LE(world.spin(fast).norm(), 1.1e4);  // its energy is that of 1e4 rad/s about another axis
        alone.step(kStep);
        for (int i = 0; i < 60; ++i) EXPECT_TRUE(world.step(kStep)), alone.step(kStep);
        for (int i = 1; i <= 3; ++i)
            EXPECT_LT((world.pose({i}).position - alone.pose({i}).position).norm(), 1e-5) << i;
    }
}

// At most 1 m/s, however deep (Settings::depenetrationSpeed), and no velocity is left.
TEST(BadScenes, OverlapsComeApartSlowly) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double depth : {0.05, 0.3, 0.9}) {
            World world(settings);
            world.add(support::floorPlane());
            world.add(body(Shape::box({1, 1, 1}), {0, 0.5 - depth, 0}));
            world.add(body(Shape::sphere(0.5), {3, 0.5 - depth, 0}));
            for (int i = 0; i < 120; ++i) {
                const Vec3 box = world.pose({1}).position, ball = world.pose({2}).position;
                world.step(kStep);
                EXPECT_LT((world.pose({1}).position - box).norm(), 1.01 * kStep) << depth;
                EXPECT_LT((world.pose({2}).position - ball).norm(), 1.01 * kStep) << depth;
            }
            for (const int i : {1, 2}) {
                EXPECT_NEAR(world.pose({i}).position.y(), 0.5, 2e-3) << depth;
                EXPECT_LT(world.velocity({i}).norm(), 1e-3) << depth;
            }
        }
}

// The explicit half step of free rotation that they had once gave them 31 to 450 times their energy.
TEST(BadScenes, ThrownRodsSettle) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world(settings);
        world.add(support::floorPlane());
        support::Random random(11);
        for (int i = 0; i < 49; ++i) {
            const Vec3 at(1.5 * (i % 7) - 4.5, 2.0 + 0.3 * (i % 5), 1.5 * (i / 7) - 4.5);
            BodyDef rod = body(Shape::box({1, 0.05, 0.05}), at, 2.5);
            rod.pose.rotation = random.rotation();
            rod.spin = random.vector(1).normalized() * random.number(10, 30), rod.velocity = random.vector(3);
            world.add(rod);
        }
        const double start = world.energy().total();
        for (int i = 0; i < 900; ++i) {
            ASSERT_TRUE(world.step(kStep)) << i;
            ASSERT_TRUE(world.report().incidents.empty()) << i;
            ASSERT_LT(world.energy().total(), 1.001 * start) << i;
        }
        for (int i = 1; i < 50; ++i) {
            EXPECT_GT(world.pose({i}).position.y(), 0.02) << i;
            EXPECT_LT(world.velocity({i}).norm(), 0.1) << i;
        }
    }
}

TEST(Trouble, ABodyLostInSpaceIsReported) {
    World world;
    const BodyId far = world.add(body(Shape::sphere(1), {99999.9, 0, 0}));
    world.setVelocity(far, {100, 0, 0}, Vec3::Zero());
    const BodyId near = world.add(body(Shape::sphere(1), Vec3::Zero()));
    EXPECT_TRUE(world.step(kStep));
    ASSERT_EQ(world.report().incidents.size(), 1u);
    EXPECT_EQ(world.report().incidents[0].trouble, Trouble::positionTooLarge);
    EXPECT_FALSE(world.has(far));
    EXPECT_TRUE(world.has(near));
    EXPECT_TRUE(world.step(kStep));
    EXPECT_TRUE(world.report().incidents.empty());
}

TEST(Trouble, AnEnergyJumpIsReportedAndAKinematicBodyExcusesIt) {
    Settings wild = Settings::seed();
    wild.nudges = 0;
    wild.baumgarte = 2.0;
    wild.slop = 0.0;
    const auto deep = [&](bool kinematic) {
        World world(wild);
        world.add(support::floorPlane());
        world.add(body(Shape::sphere(1.0), {0, -3.0, 0}));
        if (kinematic) {
            BodyDef told = support::hook({50, 50, 0});
            told.kind = BodyKind::kinematic;
            world.add(told);
        }
        world.step(kStep);
        return world.report().incidents;
    };
    ASSERT_EQ(deep(false).size(), 1u);
    EXPECT_EQ(deep(false)[0].trouble, Trouble::energyJump);
    EXPECT_TRUE(deep(true).empty());
}

// reliability.md: 100 spheres at one point
TEST(BadScenes, AHundredSpheresAtOnePointComeApart) {
    World world;
    world.add(support::floorPlane());
    for (int i = 0; i < 100; ++i) world.add(body(Shape::sphere(0.2), {0, 1, 0}));
    run(world, 120);
    EXPECT_EQ(world.report().trouble, Trouble::none);
    for (int i = 1; i <= 100; ++i) EXPECT_LT(world.pose({i}).position.norm(), 50.0);
}

TEST(BadScenes, ContradictingJointsDoNotBlowUp) {
    for (const Settings& settings : {Settings::steady(), Settings::seed()}) {
        World world(settings);
        world.setGravity(Vec3::Zero());
        const BodyId left = world.add(support::hook({-1, 0, 0}));
        const BodyId right = world.add(support::hook({1, 0, 0}));
        const BodyId ball = world.add(body(Shape::sphere(0.1), Vec3::Zero()));
        JointDef joint;
        joint.b = ball;
        joint.a = left;
        world.add(joint);
        joint.a = right;
        world.add(joint);
        run(world, 300);
        EXPECT_EQ(world.report().trouble, Trouble::none);
        EXPECT_LT(world.pose(ball).position.norm(), 1.5);
        EXPECT_LT(world.velocity(ball).norm(), 10.0);
    }
}

// The pile of everything: random shapes thrown together stay finite and above the floor.
TEST(BadScenes, AHeapOfAllShapesStaysFinite) {
    World world;
    world.add(support::floorPlane());
    support::Random random(9);
    for (int i = 0; i < 60; ++i) {
        const Shape shape = i % 3 == 0   ? Shape::sphere(random.number(0.2, 0.5))
                            : i % 3 == 1 ? Shape::box(Vec3::Constant(0.3) + random.vector(0.2).cwiseAbs())
                                         : Shape::capsule(0.2, random.number(0.5, 1.2));
        BodyDef def = body(shape, Vec3(0, 4, 0) + random.vector(2.0), random.number(0.5, 20.0));
        def.pose.rotation = random.rotation();
        def.spin = random.vector(5.0);
        world.add(def);
    }
    for (int i = 0; i < 300; ++i) ASSERT_TRUE(world.step(kStep)) << i;
    for (int i = 1; i <= 60; ++i) EXPECT_GT(world.pose({i}).position.y(), 0.0);
    EXPECT_LT(world.errors().penetration, 0.02);
}

}  // namespace
}  // namespace engine
