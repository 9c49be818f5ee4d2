// No non-finite state is ever passed on, and nothing that is put together badly hurts.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;
using support::kStep;
using support::run;

TEST(Trouble, ANotFiniteForceStopsTheWorldAtItsLastGoodState) {
    World world = support::stack(3);
    run(world, 10);
    const std::uint64_t good = world.hash();
    world.applyForce({2}, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    EXPECT_FALSE(world.step(kStep));
    EXPECT_NE(world.report().trouble, Trouble::none);
    EXPECT_EQ(world.hash(), good);
    EXPECT_EQ(world.report().step, 10);
    EXPECT_FALSE(world.step(kStep));  // it stays there
    EXPECT_EQ(world.hash(), good);
}

TEST(Trouble, NamesTheBodyThatIsTooFast) {
    World world;
    world.add(body(Shape::sphere(1), Vec3::Zero()));
    const BodyId fast = world.add(body(Shape::sphere(1), {10, 0, 0}));
    world.setVelocity(fast, {2e4, 0, 0}, Vec3::Zero());
    EXPECT_FALSE(world.step(kStep));
    EXPECT_EQ(world.report().trouble, Trouble::velocityTooLarge);
    EXPECT_EQ(world.report().troubledBody, fast);
}

TEST(Trouble, ABodyLostInSpaceIsReported) {
    World world;
    const BodyId far = world.add(body(Shape::sphere(1), {99999.9, 0, 0}));
    world.setVelocity(far, {100, 0, 0}, Vec3::Zero());
    EXPECT_FALSE(world.step(kStep));
    EXPECT_EQ(world.report().trouble, Trouble::positionTooLarge);
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
        return world.step(kStep);
    };
    EXPECT_FALSE(deep(false));
    EXPECT_TRUE(deep(true));
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
