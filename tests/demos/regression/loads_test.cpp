// Changes of force that no pose shows, and those of which a test says nothing.
#include "demos/regression/loads.h"

#include <gtest/gtest.h>

#include "demos/regression/divergence.h"
#include "demos/regression/trajectory_codec.h"
#include "demos/regression/trajectory_recorder.h"
#include "demos/text/byte_stream.h"
#include "demos/text/deflate.h"
#include "tests/demos/reading.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

using PhysicsKind = PhysicsVerdict::Kind;

/// A crate on the ground and a weight on a rope, both at rest.
const std::string kAtRest = R"(format = 1
seconds = 1.0
[world]
gravity = [0, -9.81, 0]
[[material]]
name = "wood"
density = 600.0
friction = 0.6
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "crate"
material = "wood"
shape = { box = [1, 1, 1] }
at = [0, 0.5, 0]
[[body]]
name = "weight"
shape = { sphere = 0.1 }
mass = 5.0
at = [3, 2, 0]
[[joint]]
name = "rope"
type = "ball"
a = "world"
b = "weight"
anchor = [3, 4, 0]
)";

/// Its first second.
Trajectory recorded(const SceneDescription& scene) {
    Stage stage(scene);
    TrajectoryRecorder recorder(stage, 60);
    recorder.look(stage);
    for (int step = 1; step <= 60; ++step) {
        EXPECT_TRUE(stage.step());
        recorder.look(stage);
    }
    return recorder.trajectory();
}

Trajectory restingRun(const std::string& from = "", const std::string& to = "") {
    std::string text = kAtRest;
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return recorded(readScene(text, "rest.toml", "rest"));
}

/// One body of 1 kg that touches two others: left[k] and right[k] are the impulses, N s.
Trajectory touched(const std::vector<double>& left, const std::vector<double>& right) {
    Trajectory trajectory;
    trajectory.bodies = {"ball"};
    trajectory.masses = {1.0};
    trajectory.gravity = 9.81;
    trajectory.constraints = {"contact left-ball", "contact right-ball"};
    trajectory.ends = {{-1, 0}, {-1, 0}};
    for (std::size_t k = 0; k < left.size(); ++k) {
        trajectory.hashes.push_back(0);
        trajectory.moments.push_back({static_cast<int>(k), {{}}, 0, 0, 0, {}});
        trajectory.moments.back().impulses = {{0, left[k]}, {1, right[k]}};
    }
    return trajectory;
}

std::optional<LoadChange> changedLoadOf(const Trajectory& baseline, const Trajectory& actual) {
    return changedLoad(baseline, actual, {0}, Trajectory::kAll, Tolerance{}.load);
}

TEST(Loads, TellMassAndGravityThatNoPoseShows) {
    const struct {
        const char *from, *to, *body, *line;
    } damages[] = {
        {"density = 600", "density = 900", "crate", "the load of crate differs: 5886 -> 8829 N"},
        {"mass = 5.0", "mass = 50.0", "weight", "the load of weight differs: 49.05 -> 490.5 N"},
        {"-9.81", "-1.62", "", "-> "}};
    for (const auto& damage : damages) {
        const PhysicsVerdict verdict =
            diverge(restingRun(), restingRun(damage.from, damage.to), {});
        EXPECT_EQ(verdict.kind, PhysicsKind::changed) << damage.to;
        EXPECT_EQ(verdict.field, "load") << damage.to;
        EXPECT_TRUE(*damage.body == 0 || verdict.body == damage.body) << verdict.body;
        ASSERT_FALSE(verdict.lines.empty()) << damage.to;
        EXPECT_NE(verdict.lines[0].find(damage.line), std::string::npos) << verdict.lines[0];
    }
}

TEST(Loads, AreWithinTheToleranceOrThatOfTheScene) {
    const Trajectory baseline = restingRun();
    EXPECT_NE(diverge(baseline, restingRun("friction = 0.6", "friction = 0.9"), {}).kind,
              PhysicsKind::changed);
    const PhysicsVerdict little = diverge(baseline, restingRun("mass = 5.0", "mass = 5.2"), {});
    EXPECT_NE(little.kind, PhysicsKind::changed);
    EXPECT_EQ(little.lines.back(), "the mass of weight differs: 5 -> 5.2 kg");
    Tolerance wide;
    wide.load = 2.0;
    EXPECT_NE(diverge(baseline, restingRun("density = 600", "density = 900"), wide).kind,
              PhysicsKind::changed);
}

TEST(Loads, AreKnownFromABaseline) {
    const Trajectory whole = restingRun();
    for (const std::size_t most : {std::size_t{1} << 20, std::size_t{400}}) {
        const auto kept = decodeTrajectory(encodeTrajectory(whole, resolutionOf(whole, {}), most));
        ASSERT_TRUE(kept.has_value());
        EXPECT_EQ(kept->masses, whole.masses);
        EXPECT_EQ(kept->ends, whole.ends);
        EXPECT_EQ(kept->gravity, 9.81);
        EXPECT_EQ(most < 1000, kept->moments.size() < whole.moments.size());
        EXPECT_EQ(diverge(*kept, whole, {}).kind, PhysicsKind::same);
        EXPECT_EQ(diverge(*kept, restingRun("mass = 5.0", "mass = 50.0"), {}).kind,
                  PhysicsKind::changed);
    }
}

TEST(Loads, OfThinnedTrajectoriesAreAddedUp) {
    std::vector<double> impact(64, 0.0);
    impact[37] = 5.0;
    const Trajectory thin = thinned(touched(impact, std::vector(64, 1.0)), 8);
    double left = 0.0, right = 0.0;
    for (const TrajectoryMoment& moment : thin.moments)
        for (const TrajectoryImpulse& impulse : moment.impulses)
            (impulse.constraint == 0 ? left : right) += impulse.value;
    EXPECT_LT(thin.moments.size(), 64u);
    EXPECT_EQ(left, 5.0);
    EXPECT_EQ(right, 64.0);
}

TEST(Loads, MayBeSharedOtherwiseAndComeAStepLater) {
    const std::vector<double> none(64, 0.0), half(64, 0.08), all(64, 0.16);
    EXPECT_FALSE(changedLoadOf(touched(all, none), touched(half, half)));
    EXPECT_TRUE(changedLoadOf(touched(all, none), touched(all, half)));
    EXPECT_TRUE(changedLoadOf(touched(all, half), touched(all, none)));
    for (std::size_t at = 1; at < 63; ++at) {
        std::vector<double> impact = none, later = none;
        impact[at] = later[at + 1] = 20.0;
        EXPECT_FALSE(changedLoadOf(touched(impact, none), touched(later, none))) << at;
        EXPECT_FALSE(changedLoadOf(touched(later, none), touched(impact, none))) << at;
    }
}

TEST(Loads, OfTheLastStepsAreCompared) {
    for (int count = 24; count < 40; ++count) {  // whatever the windows before the last one end with
        const std::vector<double> calm(count, 0.16);
        std::vector<double> other = calm;
        for (int k = count - 4; k < count; ++k) other[k] = 16.0;
        EXPECT_TRUE(changedLoadOf(touched(calm, calm), touched(other, calm))) << count;
    }
}

/// Of a joint that pulls a body of ten tons.
TEST(Loads, OfJointsAreComparedOneByOne) {
    const auto pulled = [](double impulse) {
        Trajectory trajectory = touched(std::vector(64, impulse), std::vector(64, 1635.0));
        trajectory.masses = {10'000.0};
        trajectory.constraints[0] = "joint rope";
        return trajectory;
    };
    const std::optional<LoadChange> change = changedLoadOf(pulled(1.5), pulled(15.0));
    ASSERT_TRUE(change.has_value());
    EXPECT_EQ(change->joint, "joint rope");
    EXPECT_NEAR(change->before, 90.0, 1e-9);
    EXPECT_NEAR(change->after, 900.0, 1e-9);
    EXPECT_FALSE(changedLoadOf(pulled(150.0), pulled(160.0)));
    EXPECT_TRUE(changedLoadOf(pulled(150.0), pulled(200.0)));
}

/// A motor holds a bar of 2 kg level at its end: 2 kg x 9.81 m/s^2 x 0.5 m.
Trajectory heldRun(double torque) {
    Trajectory trajectory = touched(std::vector(64, torque), std::vector(64, 0.3));
    trajectory.masses = {2.0};
    trajectory.extents = {{0.5, 0.1, 0.1}};
    trajectory.constraints[0] = "torque of joint arm";
    return trajectory;
}

TEST(Loads, OfJointsAreTorquesToo) {
    const PhysicsVerdict verdict = diverge(heldRun(9.81 / 60), heldRun(98.1 / 60), {});
    EXPECT_EQ(verdict.kind, PhysicsKind::changed);
    ASSERT_FALSE(verdict.lines.empty());
    EXPECT_EQ(verdict.lines[0], "step 1 (0.01667 s): the torque of joint arm differs: 9.81 -> 98.1 N m, "
                                "mean until step 16");
    EXPECT_EQ(diverge(heldRun(9.81 / 60), heldRun(10.3 / 60), {}).kind, PhysicsKind::same);
    EXPECT_EQ(diverge(heldRun(1e-5), heldRun(1e-4), {}).kind, PhysicsKind::same);  // below the floor
}

TEST(Loads, OfABrakeAreRecorded) {
    const auto braked = [](const std::string& most) {
        return recorded(test::read("[[body]]\nname = 'post'\nshape = { box = [1, 1, 1] }\nfixed = true\n"
                               "[[body]]\nname = 'arm'\nshape = { box = [1, 0.1, 0.1] }\nat = [1, 0, 0]\n"
                               "mass = 2.0\n[[joint]]\nname = 'arm'\ntype = 'hinge'\na = 'post'\nb = 'arm'\n"
                               "anchor = [0.5, 0, 0]\naxis = [0, 0, 1]\nmotor = { speed = 0, max = " +
                               most + " }\n"));
    };
    for (const auto& [most, torque] : {std::pair{"100", 9.81}, {"9", 9.0}}) {  // N m: it holds, or gives way
        const Trajectory trajectory = braked(most);
        const auto at = std::ranges::find(trajectory.constraints, "torque of joint arm");
        ASSERT_NE(at, trajectory.constraints.end());
        for (const TrajectoryImpulse& impulse : trajectory.moments.back().impulses) {
            if (&trajectory.constraints[impulse.constraint] != &*at) continue;
            EXPECT_NEAR(impulse.value, torque / 60, 1e-3) << most;
        }
    }
}

TEST(Loads, AreComparedWhateverTheTolerances) {
    Tolerance wide;
    wide.position = 0.01;
    wide.angleDegrees = 1.0;
    const Trajectory whole = restingRun("at = [0, 0.5, 0]", "at = [0.00123, 0.5, 0]");
    const auto kept = decodeTrajectory(encodeTrajectory(whole, resolutionOf(whole, wide), 1 << 20));
    ASSERT_TRUE(kept.has_value());
    Trajectory heavier = whole;
    heavier.hashes[1] += 1;
    for (TrajectoryMoment& moment : heavier.moments)
        for (TrajectoryImpulse& impulse : moment.impulses) impulse.value *= 10.0;
    EXPECT_EQ(diverge(*kept, heavier, wide).kind, PhysicsKind::changed);
}

TEST(Loads, CountOnlyWhileTheBodiesAreWhereTheyWere) {
    const std::vector<double> calm(64, 0.16);
    std::vector<double> other = calm;
    for (std::size_t k = 30; k < other.size(); ++k) other[k] = 1.0;
    const Trajectory baseline = touched(calm, calm);
    Trajectory actual = touched(other, other);
    const std::optional<LoadChange> change = changedLoadOf(baseline, actual);
    ASSERT_TRUE(change.has_value());
    EXPECT_GT(change->last, 30);
    actual.hashes[20] = 1;
    for (std::size_t k = 20; k < 64; ++k) actual.moments[k].poses[0].position.x() = 0.01;
    Tolerance wide;
    wide.position = 0.1;
    EXPECT_EQ(diverge(baseline, actual, wide).kind, PhysicsKind::bits);
}

/// As older programs wrote it.
TEST(Loads, AreUnknownInAnOldBaseline) {
    ByteWriter out;
    for (const int value : {1, 60, Trajectory::kAll, 2, 1}) out.whole(value);
    out.text("ball");
    for (const int value : {0, 0, 0, 0}) out.whole(value);  // no constraints; extents
    out.bits32(7);
    out.bits32(8);
    for (int i = 0; i < 4; ++i) out.number(0.001);
    for (int column = 0; column < 10; ++column)  // the last is w of the rotation
        for (const int value : {0, column == 9 ? 1000 : 0, 0}) out.whole(value);
    const std::optional<Trajectory> old = decodeTrajectory(deflated(out.bytes()));
    ASSERT_TRUE(old.has_value());
    EXPECT_TRUE(old->masses.empty());
    EXPECT_EQ(old->moments.size(), 2u);
    EXPECT_EQ(diverge(*old, *old, {}).kind, PhysicsKind::same);
}

}  // namespace
}  // namespace demos::test
