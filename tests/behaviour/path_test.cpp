// A point on a Catmull-Rom spline.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "engine/constraints/catmull_rom.h"
#include "tests/support/joints.h"

namespace engine {
namespace {

using support::ballOf;
using support::kGravity;
using support::kStep;
using support::run;

const std::vector<Vec3> kWave = {{0, 2, 0}, {1, 1, 0.2}, {2, 0.4, -0.2}, {3, 1, 0}, {4, 1.5, 0.3}};

TEST(CatmullRom, GoesThroughItsPointsSmoothly) {
    for (const bool closed : {false, true})
        for (int i = 0; i < 5; ++i) {
            EXPECT_LT((curveAt(kWave, closed, i).at - kWave[i]).norm(), 1e-12);
            if (i == 0 || i == 4) continue;
            const CurvePoint before = curveAt(kWave, closed, i - 1e-9);
            EXPECT_LT((before.first - curveAt(kWave, closed, i).first).norm(), 1e-7);
            EXPECT_LT((before.first - 0.5 * (kWave[i + 1] - kWave[i - 1])).norm(), 1e-7);
        }
    const CurvePoint p = curveAt(kWave, false, 1.3);
    const double dt = 1e-5;
    const Vec3 slope =
        (curveAt(kWave, false, 1.3 + dt).at - curveAt(kWave, false, 1.3 - dt).at) / (2 * dt);
    EXPECT_LT((p.first - slope).norm(), 1e-9);
}

TEST(CatmullRom, FindsTheNearestPoint) {
    for (const double t : {0.2, 1.7, 3.4}) {
        const CurvePoint p = curveAt(kWave, false, t);
        const Vec3 beside = p.at + 0.05 * p.first.cross(Vec3::UnitZ()).normalized();
        EXPECT_NEAR(nearestOnCurve(kWave, false, beside), t, 1e-9);
    }
}

TEST(CatmullRom, MeasuresAStraightLine) {
    const std::vector<Vec3> line = {{0, 0, 0}, {1, 2, 2}, {2, 4, 4}};
    EXPECT_NEAR(curveLength(line, false, 0, 1) + curveLength(line, false, 1, 1.5), 4.5, 1e-12);
}

/// A bead on the wire.
struct Wire {
    World world;
    BodyId bead;
    JointId joint;

    Wire(const std::vector<Vec3>& path, bool closed, const Motor& motor = {}) {
        const BodyId hook = world.add(support::hook());
        bead = world.add(ballOf(2, 0.01, path[0]));
        JointDef def;
        def.type = JointType::path;
        def.a = hook, def.b = bead;
        def.path = path;
        def.closed = closed;
        def.free[0].motor = motor;
        joint = world.add(def);
    }
};

// v^2 = 2 g (y_0 - y), wherever it is
TEST(Path, ABeadKeepsItsEnergy) {
    Wire wire(kWave, false);
    for (int i = 0; i < 600; ++i) {
        wire.world.step(1.0 / 480);
        const double fallen = 2.0 - wire.world.pose(wire.bead).position.y();
        EXPECT_NEAR(wire.world.velocity(wire.bead).squaredNorm(), 2 * kGravity * fallen,
                    0.02 * 2 * kGravity);
        EXPECT_LT(wire.world.joint(wire.joint).separation, 1e-3);
    }
    EXPECT_GT(wire.world.joint(wire.joint).position, 2.0);
}

TEST(Path, OfAStraightLineIsAnIncline) {
    Wire wire({{0, 0, 0}, {4, -3, 0}, {8, -6, 0}}, false);
    constexpr int kLong = 80;  // into the second piece
    run(wire.world, kLong);
    const double h = kStep / wire.world.report().substeps, n = kLong * wire.world.report().substeps;
    const JointState state = wire.world.joint(wire.joint);
    EXPECT_NEAR(state.position, 0.5 * 0.6 * kGravity * h * h * n * (n + 1), 1e-6);
    EXPECT_NEAR(state.speed, 0.6 * kGravity * kLong * kStep, 1e-6);
    EXPECT_NEAR(state.force.norm(), 0.8 * 2 * kGravity, 1e-4);
}

TEST(Path, IsFoundAnewByABodyThatIsPutElsewhere) {
    Wire wire(kWave, false);
    wire.world.setPose(wire.bead, {{3, 1.01, 0}, Quat::Identity()});
    wire.world.step(kStep);
    EXPECT_LT(wire.world.joint(wire.joint).separation, 0.02);
    EXPECT_NEAR(wire.world.pose(wire.bead).position.x(), 3.0, 0.01);
}

// Over the hills of a closed track at constant speed; after one lap it is back at the start.
TEST(Path, AMotorKeepsItsSpeedRoundATrack) {
    const std::vector<Vec3> track = {{1, 0, 0}, {0, 0.5, 1}, {-1, 0, 0}, {0, -0.3, -1}};
    Wire wire(track, true, {1.0, kUnlimited});
    double round = 0.0;
    for (int i = 0; i < 4; ++i) round += curveLength(track, true, i, i + 1.0);
    const int steps = static_cast<int>(round / kStep);
    for (int i = 0; i < steps; ++i) {
        wire.world.step(kStep);
        EXPECT_NEAR(wire.world.velocity(wire.bead).norm(), 1.0, 0.01);
    }
    EXPECT_LT((wire.world.pose(wire.bead).position - track[0]).norm(), 0.03);
}

}  // namespace
}  // namespace engine
