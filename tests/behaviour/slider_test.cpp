// Sliders, and six degrees of freedom set to be other joints.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "tests/support/joints.h"

namespace engine {
namespace {

using support::ballOf;
using support::jointAt;
using support::kGravity;
using support::kStep;
using support::run;

/// The sum of v-then-x integration with a constant acceleration.
double fallen(double acceleration, const World& world, int steps) {
    const double n = steps * world.report().substeps, h = kStep / world.report().substeps;
    return 0.5 * acceleration * h * h * n * (n + 1);
}

/// A block hanging next to a rail inclined by 30 degrees, down along x.
struct SlopingRail {
    World world;
    BodyId block;
    JointId joint;
    Vec3 down{cosine(radians(30)), -sine(radians(30)), 0};

    explicit SlopingRail(JointDef set = {}, const Settings& settings = Settings::steady())
        : world(settings) {
        const BodyId rail = world.add(support::hook());
        block = world.add(support::body(Shape::box({0.4, 0.2, 0.2}), {0.2, 0.1, 0.5}, 3.0));
        JointDef def = jointAt(world, JointType::slider, rail, block, Vec3::Zero(), down);
        if (set.type == JointType::sixDof) {
            def.type = JointType::sixDof;
            def.axis2 = {0, 0, 1};
            def.free = set.free;
        }
        joint = world.add(def);
    }
};

/// All locked except translation along x.
JointDef sixDofSlider() {
    JointDef def;
    def.type = JointType::sixDof;
    for (int i = 1; i < 6; ++i) def.free[i].locked = true;
    return def;
}

TEST(Slider, SlidesDownWithGSin) {
    for (const JointDef& set : {JointDef{}, sixDofSlider()}) {
        SlopingRail it(set);
        run(it.world, 120);
        const JointState state = it.world.joint(it.joint);
        EXPECT_NEAR(state.position, fallen(kGravity / 2, it.world, 120), 1e-6);
        EXPECT_NEAR(state.speed, kGravity, 1e-6);
        EXPECT_LT(state.separation, 1e-9);
        EXPECT_LT(it.world.spin(it.block).norm(), 1e-9);
        // the rail pushes perpendicular to itself: m g cos 30
        EXPECT_NEAR(state.force.norm(), 3 * kGravity * cosine(radians(30)), 1e-4);
        EXPECT_NEAR(state.force.dot(it.down), 0.0, 1e-6);
    }
}

TEST(Slider, IsTheSameByEveryMethod) {
    SlopingRail steady;
    run(steady.world, 60);
    for (const Method method : {Method::pgs, Method::pgsMatrix, Method::direct}) {
        Settings settings = Settings::steady();
        settings.method = method;
        settings.sweeps = 200;
        settings.tolerance = 1e-9;
        SlopingRail other({}, settings);
        run(other.world, 60);
        EXPECT_NEAR(other.world.joint(other.joint).position,
                    steady.world.joint(steady.joint).position, 1e-5);
    }
}

// On a rotating rod, as in a governor. In the rod's axes the block is accelerated by w^2 r
// outwards.
TEST(Slider, IsFlungOutByWhatTurns) {
    World world = support::weightless();
    BodyDef drum = support::hook();
    drum.kind = BodyKind::kinematic;
    drum.spin = {0, 2, 0};
    const BodyId a = world.add(drum), bead = world.add(ballOf(1, 0.01, {0.1, 0, 0}));
    JointDef def = jointAt(world, JointType::slider, a, bead, Vec3::Zero(), Vec3::UnitX());
    def.anchorB = Vec3::Zero();
    const JointId id = world.add(def);
    world.setVelocity(bead, {0, 0, -0.2}, {0, 2, 0});
    for (int i = 0; i < 480; ++i) world.step(1.0 / 480);
    EXPECT_NEAR(world.joint(id).position, 0.1 * std::cosh(2.0), 0.01 * std::cosh(2.0) * 0.1);
    EXPECT_LT(world.joint(id).separation, 1e-5);
}

TEST(SixDof, AllLockedIsAWeld) {
    World world;
    const BodyId wall = world.add(support::hook());
    const BodyId beam = world.add(support::body(Shape::box({1, 0.1, 0.1}), {0.5, 0, 0}, 4.0));
    JointDef def = jointAt(world, JointType::sixDof, wall, beam, Vec3::Zero());
    for (Freedom& freedom : def.free) freedom.locked = true;
    const JointId id = world.add(def);
    run(world, 120);
    const JointState state = world.joint(id);
    EXPECT_NEAR(state.force.y(), 4 * kGravity, 1e-6);
    EXPECT_NEAR(state.torque.z(), 4 * kGravity * 0.5, 1e-6);
    EXPECT_LT(state.separation, 1e-5);
    EXPECT_NEAR(world.pose(beam).position.y(), 0.0, 1e-5);
}

// 1000 kg on twelve links of 1 kg, let go level, by hinges made of six degrees of freedom.
TEST(SixDof, CarriesAThousandTimesItsLinks) {
    World world;
    BodyId above = world.add(support::hook());
    std::vector<JointId> joints;
    constexpr int kLinks = 12;
    for (int i = 0; i <= kLinks; ++i) {
        const Vec3 at{i + (i < kLinks ? 0.5 : 0.0), 0, 0};
        const BodyId next = world.add(support::body(Shape::box({1, 0.1, 0.1}), at, i < kLinks ? 1.0 : 1e3));
        JointDef def = jointAt(world, JointType::sixDof, above, next, Vec3(i, 0, 0));
        for (const int k : {0, 1, 2, 3, 4}) def.free[k].locked = true;
        joints.push_back(world.add(def));
        above = next;
    }
    double worst = 0.0;
    const double before = world.energy().total();
    for (int i = 0; i < 600; ++i) {
        run(world, 1);
        for (const JointId id : joints) worst = larger(worst, world.joint(id).separation);
        EXPECT_LT(world.energy().total(), before + 100.0) << i;  // J; 1000 kg fall by 12 m
    }
    EXPECT_LT(worst, 1e-4);
}

// Per axis: free along x, limited along y, a motor about z, a spring along z, the rest locked.
TEST(SixDof, TakesEachAxisAsItIsSet) {
    World world;
    const BodyId wall = world.add(support::hook()), ball = world.add(ballOf(2, 0.1, {0, 0, 0}));
    JointDef def = jointAt(world, JointType::sixDof, wall, ball, Vec3::Zero());
    def.free[1].limits = {-0.2, 0.1};
    def.free[2].spring = {1.0, 1.0};
    def.free[2].rest = 0.3;
    def.free[3].locked = def.free[4].locked = true;
    def.free[5].motor = {2.0, 10.0};
    const JointId id = world.add(def);
    world.setVelocity(ball, {0.5, 0, 0}, Vec3::Zero());
    run(world, 240);
    const JointState state = world.joint(id);
    EXPECT_NEAR(state.positions[0], 2.0, 1e-3);
    EXPECT_NEAR(state.positions[1], -0.2, 1e-5);
    EXPECT_NEAR(state.positions[2], 0.3, 1e-3);
    EXPECT_NEAR(state.positions[3], 0.0, 1e-6);
    EXPECT_NEAR(state.positions[4], 0.0, 1e-6);
    EXPECT_NEAR(state.positions[5], 8.0, 0.05);  // counted over the turn
    EXPECT_NEAR(state.speeds[5], 2.0, 1e-6);
}

}  // namespace
}  // namespace engine
