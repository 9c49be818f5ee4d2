// Trajectories: recorded, encoded, and compared.
#include "demos/regression/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "demos/regression/divergence.h"
#include "demos/regression/trajectory_codec.h"
#include "demos/regression/trajectory_recorder.h"
#include "demos/text/byte_stream.h"
#include "demos/text/deflate.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

constexpr const char* kPile = R"(format = 1
seconds = 1.0
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[repeat]]
count = 4
step = [0, 1.1, 0]
body = { name = "box{i}", shape = { box = [1, 1, 1] }, at = [0, 0.6, 0], turn_deg = [0, 9, 2] }
[[joint]]
type = "ball"
a = "world"
b = "bob"
anchor = [3, 4, 0]
[[body]]
name = "bob"
shape = { sphere = 0.2 }
at = [4, 4, 0]
)";

/// `change`: is applied to the stage after 20 steps.
Trajectory played(const std::function<void(Stage&)>& change = {}) {
    const SceneDescription scene = readScene(kPile, "pile.toml", "pile");
    Stage stage(scene);
    const int steps = 60;
    TrajectoryRecorder recorder(stage, steps);
    recorder.look(stage);
    for (int step = 1; step <= steps; ++step) {
        if (step == 21 && change) change(stage);
        EXPECT_TRUE(stage.step());
        recorder.look(stage);
    }
    return recorder.trajectory();
}

void moveTop(Stage& stage, double by) {
    engine::Pose pose = stage.world.pose(stage.bodies[4]);
    pose.position.x() += by;
    stage.world.setPose(stage.bodies[4], pose);
}

double farthest(const Trajectory& a, const Trajectory& b) {
    double most = 0.0;
    for (std::size_t k = 0; k < a.moments.size(); ++k)
        for (std::size_t i = 0; i < a.bodies.size(); ++i)
            most = std::max(most, (a.moments[k].poses[i].position - b.moments[k].poses[i].position)
                                      .cwiseAbs()
                                      .maxCoeff());
    return most;
}

TEST(Trajectory, HoldsEveryStepOfAShortRun) {
    const Trajectory trajectory = played();
    EXPECT_EQ(trajectory.hashes.size(), 61u);
    ASSERT_EQ(trajectory.moments.size(), 61u);
    EXPECT_EQ(trajectory.moments.back().step, 60);
    EXPECT_EQ(trajectory.bodies,
              (std::vector<std::string>{"floor", "box0", "box1", "box2", "box3", "bob"}));
    EXPECT_EQ(trajectory.extents[1], Vec3(0.5, 0.5, 0.5));
    EXPECT_EQ(trajectory.extents[0], Vec3(0, 0, 0));
}

TEST(Trajectory, KnowsWhatContactsAndJointsDid) {
    const Trajectory trajectory = played();
    std::map<std::string, double> last;
    for (const TrajectoryImpulse& impulse : trajectory.moments.back().impulses)
        last[trajectory.constraints[impulse.constraint]] = impulse.value;
    ASSERT_EQ(last.count("contact floor-box0"), 1u);
    ASSERT_EQ(last.count("joint world-bob"), 1u);
    // The floor carries the weight of four boxes of 1000 kg: m g dt in each step.
    EXPECT_NEAR(last["contact floor-box0"], 4 * 1000 * 9.81 / 60, 0.05 * 4 * 1000 * 9.81 / 60);
}

TEST(Trajectory, ComesBackWithinItsResolution) {
    const Trajectory trajectory = played();
    const Tolerance tolerance;
    const TrajectoryResolution resolution = resolutionOf(trajectory, tolerance);
    const auto bytes = encodeTrajectory(trajectory, resolution, 1u << 20);
    const std::optional<Trajectory> back = decodeTrajectory(bytes);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->hashes, trajectory.hashes);
    EXPECT_EQ(back->constraints, trajectory.constraints);
    ASSERT_EQ(back->moments.size(), trajectory.moments.size());
    EXPECT_LE(farthest(trajectory, *back), 1.01 * resolution.position);
    for (std::size_t k = 0; k < trajectory.moments.size(); ++k) {
        EXPECT_LE(std::abs(trajectory.moments[k].energy - back->moments[k].energy),
                  1.01 * resolution.energy);
        for (std::size_t i = 0; i < trajectory.bodies.size(); ++i)
            EXPECT_LT(trajectory.moments[k].poses[i].rotation.angularDistance(
                          back->moments[k].poses[i].rotation),
                      6 * resolution.rotation);
        ASSERT_EQ(trajectory.moments[k].impulses.size(), back->moments[k].impulses.size());
        for (std::size_t i = 0; i < trajectory.moments[k].impulses.size(); ++i)
            EXPECT_NEAR(trajectory.moments[k].impulses[i].value, back->moments[k].impulses[i].value,
                        0.51 * resolution.impulse);
    }
    EXPECT_LT(bytes.size(), 61 * 6 * 7 * sizeof(double) / 8);  // an eighth of the poses alone
}

TEST(Trajectory, GivesUpMomentsForSpaceLateOnesFirst) {
    const Trajectory trajectory = played();
    const auto bytes = encodeTrajectory(trajectory, resolutionOf(trajectory, {}), 1500);
    EXPECT_LE(bytes.size(), 1500u);
    const std::optional<Trajectory> back = decodeTrajectory(bytes);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->hashes.size(), 61u);
    EXPECT_EQ(back->moments.front().step, 0);
    EXPECT_EQ(back->moments.back().step, 60);
    EXPECT_EQ(back->moments[1].step, 1);
    EXPECT_LT(back->moments.size(), 61u);
    for (std::size_t k = 2; k + 1 < back->moments.size(); ++k)  // except the last
        EXPECT_GE(back->moments[k].step - back->moments[k - 1].step,
                  back->moments[k - 1].step - back->moments[k - 2].step);
}

TEST(Trajectory, RefusesBytesThatAreNone) {
    const Trajectory trajectory = played();
    const std::vector<std::uint8_t> good =
        encodeTrajectory(trajectory, resolutionOf(trajectory, {}), 1u << 20);
    EXPECT_FALSE(decodeTrajectory({}).has_value());
    for (std::size_t size = 0; size < good.size(); size += 97)
        EXPECT_FALSE(decodeTrajectory(std::span(good).first(size)).has_value()) << size;
    for (std::size_t at = 0; at < good.size(); at += 31) {  // zlib's checksum detects each change
        std::vector<std::uint8_t> bad = good;
        bad[at] ^= 0x10;
        const std::optional<Trajectory> back = decodeTrajectory(bad);
        // except in the unused bits of the last byte before it
        EXPECT_TRUE(!back || back->hashes == trajectory.hashes) << at;
    }
}

/// Changes before compression: a forged baseline can have a correct zlib checksum.
TEST(Trajectory, SurvivesBytesThatAreMadeUp) {
    const Trajectory trajectory = played();
    const auto good =
        inflated(encodeTrajectory(trajectory, resolutionOf(trajectory, {}), 1u << 20), 1u << 24);
    ASSERT_TRUE(good.has_value());
    std::uint32_t chance = 1;
    const auto next = [&chance] { return (chance = chance * 1664525u + 1013904223u) >> 8; };
    int refused = 0;
    for (int round = 0; round < 500; ++round) {
        std::vector<std::uint8_t> bad = *good;
        for (int flips = 1 + round % 4; flips > 0; --flips)
            bad[next() % (round % 2 ? bad.size() : 60)] = static_cast<std::uint8_t>(next());
        if (round % 5 == 0) bad.resize(next() % bad.size());
        const std::optional<Trajectory> read = decodeTrajectory(deflated(bad));
        if (!read) ++refused;
        if (!read) continue;
        for (const TrajectoryMoment& moment : read->moments) {
            EXPECT_EQ(moment.poses.size(), read->bodies.size());
            for (const TrajectoryImpulse& impulse : moment.impulses)
                EXPECT_LT(static_cast<std::size_t>(impulse.constraint), read->constraints.size());
        }
    }
    EXPECT_GT(refused, 150);
}

/// A run without bodies, constraints or motion, as a few kilobytes can claim it.
std::vector<std::uint8_t> emptyRun(int steps) {
    ByteWriter out;
    for (const std::int64_t value : {2, 60, Trajectory::kAll, steps, 0, 0}) out.whole(value);
    out.number(9.81);
    for (int step = 0; step < steps; ++step) out.bits32(0);
    for (int resolution = 0; resolution < 4; ++resolution) out.number(1e-3);
    for (int number = 0; number < 3 * (1 + steps); ++number) out.whole(0);
    return deflated(out.bytes());
}

TEST(Trajectory, MoreMomentsThanARunRecordsAreRefused) {
    EXPECT_TRUE(decodeTrajectory(emptyRun(1000)).has_value());
    EXPECT_FALSE(decodeTrajectory(emptyRun(4'000'001)).has_value());
}

TEST(Divergence, TheSameRunIsTheSame) {
    const PhysicsVerdict verdict = diverge(played(), played(), {});
    EXPECT_EQ(verdict.kind, PhysicsVerdict::Kind::same);
    EXPECT_EQ(verdict.firstBits, -1);
    EXPECT_TRUE(verdict.lines.empty());
}

TEST(Divergence, ReportsTheFirstStepBodyFieldAndConstraint) {
    const PhysicsVerdict verdict =
        diverge(played(), played([](Stage& s) { moveTop(s, 0.002); }), {});
    EXPECT_EQ(verdict.kind, PhysicsVerdict::Kind::changed);
    EXPECT_EQ(verdict.firstBits, 21);
    EXPECT_EQ(verdict.step, 21);
    EXPECT_EQ(verdict.every, 1);
    EXPECT_EQ(verdict.body, "box3");
    EXPECT_EQ(verdict.field, "x");
    EXPECT_NEAR(verdict.difference, 0.002, 2e-4);
    EXPECT_EQ(verdict.constraint.find("contact box"), 0u) << verdict.constraint;
    EXPECT_NE(verdict.before, verdict.after);
    ASSERT_FALSE(verdict.lines.empty());
    EXPECT_EQ(verdict.lines[0].find("step 21 (0.35 s): box3 x differs by"), 0u) << verdict.lines[0];
    EXPECT_NE(verdict.lines[0].find(verdict.constraint + " lambda"), std::string::npos);
    EXPECT_GT(verdict.used, 10.0);
}

TEST(Divergence, ABitIsNotAMillimetre) {
    const auto nudged = played([](Stage& s) { moveTop(s, 1e-9); });
    const PhysicsVerdict verdict = diverge(played(), nudged, {});
    EXPECT_EQ(verdict.kind, PhysicsVerdict::Kind::bits);
    EXPECT_EQ(verdict.firstBits, 21);
    EXPECT_EQ(verdict.step, -1);
    EXPECT_LT(verdict.used, 1.0);
    ASSERT_EQ(verdict.lines.size(), 1u);
    EXPECT_NE(verdict.lines[0].find("from step 21 on"), std::string::npos);
    Tolerance fine;
    fine.position = 1e-10;
    EXPECT_EQ(diverge(played(), nudged, fine).kind, PhysicsVerdict::Kind::changed);
}

TEST(Divergence, SeesATurn) {
    const auto turn = [](Stage& stage) {
        engine::Pose pose = stage.world.pose(stage.bodies[4]);
        pose.rotation = Quat(Eigen::AngleAxisd(0.01, Vec3::UnitY())) * pose.rotation;
        stage.world.setPose(stage.bodies[4], pose);
    };
    const PhysicsVerdict verdict = diverge(played(), played(turn), {});
    EXPECT_EQ(verdict.kind, PhysicsVerdict::Kind::changed);
    EXPECT_EQ(verdict.body, "box3");
    EXPECT_EQ(verdict.field, "turn");
    EXPECT_NEAR(verdict.difference, 0.573, 0.05);
}

TEST(Divergence, WorksOnWhatABaselineKeeps) {
    const Trajectory trajectory = played();
    const std::optional<Trajectory> kept =
        decodeTrajectory(encodeTrajectory(trajectory, resolutionOf(trajectory, {}), 1u << 20));
    ASSERT_TRUE(kept.has_value());
    EXPECT_EQ(diverge(*kept, trajectory, {}).kind, PhysicsVerdict::Kind::same);
    const auto nudged = played([](Stage& s) { moveTop(s, 1e-9); });
    EXPECT_EQ(diverge(*kept, nudged, {}).kind, PhysicsVerdict::Kind::bits);
    const auto moved = diverge(*kept, played([](Stage& s) { moveTop(s, 0.001); }), {});
    EXPECT_EQ(moved.kind, PhysicsVerdict::Kind::changed);
    EXPECT_EQ(moved.step, 21);
    EXPECT_EQ(moved.body, "box3");
}

TEST(Divergence, ReportsBodiesThatCameAndWent) {
    Trajectory more = played(), less = more;
    less.bodies[5] = "weight";
    const PhysicsVerdict verdict = diverge(more, less, {});
    EXPECT_EQ(verdict.kind, PhysicsVerdict::Kind::changed);
    ASSERT_EQ(verdict.lines.size(), 2u);
    EXPECT_EQ(verdict.lines[0], "body bob is gone");
    EXPECT_EQ(verdict.lines[1], "body weight is new");
}

TEST(ByteReader, ATextHasNoMoreBytesThanFollowItsLength) {
    const std::vector<std::uint8_t> bytes = {4, 'a'};  // a length of 2
    ByteReader reader(bytes);
    EXPECT_EQ(reader.text(10), "");
    EXPECT_FALSE(reader.good());
    EXPECT_EQ(reader.left(), 1u);
    EXPECT_EQ(reader.whole(), 0);
}

}  // namespace
}  // namespace demos::test
