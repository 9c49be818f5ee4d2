// Every kind of expectation can hold and can fail.

#include "demos/play/expect.h"

#include <gtest/gtest.h>

#include "demos/scene/reader.h"

namespace demos {
namespace {

const std::string kFalling =
    "format = 1\nseconds = 1\n"
    "[[body]]\nname = 'ball'\nshape = { sphere = 0.1 }\nat = [0, 9, 0]\nvelocity = [2, 0, 0]\n";
const std::string kSmallSwing =
    "format = 1\nseconds = 5\n[world]\nhz = 240\n"
    "[[body]]\nname = 'bob'\nshape = { sphere = 0.1 }\nat = [0.1, 0, 0]\n"
    "[[joint]]\ntype = 'distance'\nname = 'rod'\na = 'world'\nb = 'bob'\nanchor_a = [0, 1, 0]\n";
const std::string kSpinning =
    "format = 1\nseconds = 1\n[world]\ngravity = [0, 0, 0]\n"
    "[[body]]\nname = 'top'\nshape = { sphere = 0.1 }\nspin = [1, 0, 0]\n"
    "[[body]]\nname = 'still'\nshape = { sphere = 0.1 }\nat = [5, 0, 0]\n";
const std::string kDropped =
    "format = 1\nseconds = 1\n[[body]]\nname = 'floor'\nshape = { plane = [0, 1, 0] }\nfixed = "
    "true\n[[body]]\nname = 'ball'\nshape = { sphere = 0.1 }\nat = [0, 1.1, 0]\n";
const std::string kPressed =  // overlaps by 10 mm at the start
    "format = 1\nseconds = 0.2\n[[body]]\nname = 'floor'\nshape = { plane = [0, 1, 0] }\nfixed = "
    "true\n"
    "[[body]]\nname = 'box'\nshape = { box = [1, 1, 1] }\nat = [0, 0.49, 0]\n";

ExpectationResult check(const std::string& scene, const std::string& expectation) {
    Stage stage(readScene(scene + "[[expect]]\nwhy = 'because'\n" + expectation, "a", "a"));
    ExpectationChecker checker(stage);
    checker.look(stage);
    const int steps = static_cast<int>(stage.scene.seconds * stage.scene.hz + 0.5);
    for (int i = 0; i < steps && stage.step(); ++i) checker.look(stage);
    return checker.results().at(0);
}

struct Case {
    const char* name;
    std::string scene, holds, fails;
    double value, tolerance;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class Expectations : public testing::TestWithParam<Case> {};

TEST_P(Expectations, HoldOrFail) {
    const Case& c = GetParam();
    const ExpectationResult holds = check(c.scene, c.holds), fails = check(c.scene, c.fails);
    EXPECT_TRUE(holds.passed) << holds.text << ": " << holds.value;
    EXPECT_FALSE(fails.passed) << fails.text << ": " << fails.value;
    EXPECT_NEAR(holds.value, c.value, c.tolerance) << holds.text;
    EXPECT_EQ(holds.why, "because");
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Expectations,
    testing::Values(
        // 1 s at 2 m/s
        Case{"drift", kFalling, "what = 'drift'\nbelow = 2.001\n", "what = 'drift'\nbelow = 1.9\n",
             2.0, 1e-9},
        // v^2 = 2^2 + 9.81^2
        Case{"speed", kFalling, "what = 'speed'\nnear = 10.0118\nwithin = 0.001\n",
             "what = 'speed'\nbelow = 10\n", 10.0118, 1e-4},
        // a fall of 9.81 / 2 m, plus half a sub-step
        Case{"position", kFalling, "what = 'position'\nnear = [2, 4.095, 0]\nwithin = 0.03\n",
             "what = 'position'\nnear = [2, 4.095, 0]\nwithin = 0.01\n", 0.0204, 1e-3},
        // the floor takes all energy of the fall; free fall alone conserves it to round-off
        Case{"energy", kDropped, "what = 'energy'\nbelow = 1.2\n",
             "what = 'energy'\nbelow = 0.5\n", 1.086, 0.01},
        Case{"count", kFalling, "what = 'count'\nnear = 1\nwithin = 0\n",
             "what = 'count'\nbelow = 1\n", 1.0, 0.0},
        // 1 rad in 1 s
        Case{"angle", kSpinning,
             "what = 'angle_deg'\nof = ['top']\nnear = 57.29578\nwithin = 0.01\n",
             "what = 'angle_deg'\nof = ['top']\nbelow = 57\n", 57.29578, 1e-3},
        // at rest on the floor: its radius, whatever its initial height
        Case{"height", kDropped, "what = 'height'\nabove = 0.09\n",
             "what = 'height'\nabove = 0.2\n", 0.1, 0.002},
        // one stays at 0 m, the other at 5 m
        Case{"spread", kSpinning, "what = 'spread'\nnear = 2.5\nwithin = 1e-9\n",
             "what = 'spread'\nbelow = 2.4\n", 2.5, 1e-9},
        // A small swing: 2 pi sqrt(l / g) (1 + A^2 / 16), l^2 = 1.01, A = 0.0997 rad
        Case{"period", kSmallSwing, "what = 'period'\nnear = 2.0123\nwithin = 0.002\n",
             "what = 'period'\nbelow = 2\n", 2.0123, 0.002},
        Case{"separation", kSmallSwing, "what = 'separation'\nof = ['rod']\nbelow = 1e-6\n",
             "what = 'separation'\nabove = 1e-3\n", 0.0, 1e-6},
        Case{"penetration", kPressed, "what = 'penetration'\nnear = 0.01\nwithin = 1e-9\n",
             "what = 'penetration'\nbelow = 0.01\n", 0.01, 1e-9}),
    [](const testing::TestParamInfo<Case>& c) { return std::string(c.param.name); });

TEST(ExpectationWindow, OpensAndCloses) {
    // 2 m/s: 1 m at 0.5 s
    EXPECT_TRUE(check(kFalling, "what = 'drift'\nbelow = 1.2\nuntil = 0.5\n").passed);
    // The overlap has disappeared by then
    EXPECT_TRUE(check(kPressed, "what = 'penetration'\nbelow = 0.009\nafter = 0.1\n").passed);
}

TEST(ExpectationWindow, ClosesBetweenTwoSteps) {
    // 2 m/s along x: 1.01 m at 0.505 s, which is not a step of 60 Hz; the fall is 9.81 t^2 / 2
    const ExpectationResult r =
        check(kFalling, "what = 'position'\nnear = [1.01, 7.749, 0]\n"
                        "within = 0.02\nuntil = 0.505\n");
    EXPECT_TRUE(r.passed) << r.value;
    EXPECT_NEAR(r.value, 0.0104, 0.0005);  // g t h / 2 of sub-steps of 1/240 s
}

TEST(ExpectationBound, HoldsForEveryBody) {
    // The top turns, the other does not: "above" applies to the least value, "below" to the largest.
    EXPECT_FALSE(check(kSpinning, "what = 'angle_deg'\nabove = 10\n").passed);
    EXPECT_FALSE(check(kSpinning, "what = 'angle_deg'\nbelow = 10\n").passed);
    EXPECT_TRUE(check(kSpinning, "what = 'angle_deg'\nabove = 10\nof = ['top']\n").passed);
}

TEST(ExpectationText, SaysWhatWasAsked) {
    const ExpectationResult r =
        check(kFalling, "what = 'drift'\nof = ['ball']\nbelow = 0.0001\nuntil = 0.5\n");
    EXPECT_EQ(r.text, "largest drift of ball below 0.0001 m, 0 s to 0.5 s");
    EXPECT_EQ(r.unit, "m");
}

TEST(ExpectationText, NamesTheWorstBodyAndItsTime) {
    const auto worst = [](const std::string& scene, const std::string& expectation) {
        return cameOut(check(scene, expectation));
    };
    const std::string two = kSpinning + "[[body]]\nname = 'slow'\nshape = { sphere = 0.1 }\n"
                                        "at = [9, 0, 0]\nspin = [0.5, 0, 0]\n";
    EXPECT_EQ(worst(two, "what = 'angle_deg'\nof = ['top', 's*']\nbelow = 40\n"),
              "57.2958 deg ('top' at 1 s)");
    EXPECT_EQ(worst(two, "what = 'angle_deg'\nof = 's*'\nabove = 10\n"), "0 deg ('still' at 0 s)");
    EXPECT_EQ(worst(kSpinning, "what = 'angle_deg'\nof = 't*'\nbelow = 60\n"), "57.2958 deg");
    EXPECT_EQ(worst(two, "what = 'count'\nabove = 1\n"),
              "0 ('top', 'still', 'slow' did not move)");
    EXPECT_EQ(worst(kFalling, "what = 'count'\nbelow = 1\n"), "1 ('ball' moved)");
    EXPECT_EQ(worst(kSpinning, "what = 'position'\nof = 's*'\nnear = [0, 0, 0]\nwithin = 1\n"),
              "5 m ('still')");
    EXPECT_EQ(worst(kPressed, "what = 'penetration'\nbelow = 0.001\n"), "0.01 m (at 0 s)");
}

TEST(ExpectationText, SaysOfWhichValueItIs) {
    EXPECT_TRUE(check(kDropped, "what = 'height'\nabove = 0.2\n").text.starts_with("least height"));
    EXPECT_TRUE(check(kSpinning, "what = 'angle_deg'\nbelow = 9\n").text.starts_with("largest angle"));
    EXPECT_TRUE(check(kFalling, "what = 'count'\nbelow = 1\n").text.starts_with("count of"));
}

TEST(FailedLine, SaysHowManyAndTheFirst) {
    const ExpectationResult good{"a", 1.0, "m", true, ""}, bad{"b", 2.0, "m", false, ""};
    ExpectationResult later = bad;
    later.finished = false;  // its window was still open
    EXPECT_EQ(failedLine({good, later}), "");
    EXPECT_EQ(failedLine({bad}), "the expectation failed: b: 2 m");
    EXPECT_EQ(failedLine({good, bad}), "1 of 2 expectations failed: b: 2 m");
    EXPECT_EQ(failedLine({bad, bad, good}), "2 of 3 expectations failed, the first: b: 2 m");
}

TEST(ExpectationPeriod, NeedsAFullSwing) {
    const ExpectationResult r = check(kFalling, "what = 'period'\nbelow = 0.1\n");
    EXPECT_FALSE(r.passed);
    EXPECT_NE(r.text.find("not one full swing"), std::string::npos) << r.text;
}

// A motor needs 1.6 s to bring a ball, in the middle of its way at the start, to half a turn a second.
TEST(ExpectationPeriod, DoesNotBeginWithAStartInTheMiddle) {
    for (const char* x : {"-1e-9", "0", "1e-9"}) {
        const ExpectationResult r = check(
            "format = 1\nseconds = 12\n[world]\ngravity = [0, 0, 0]\n"
            "[[body]]\nname = 'ball'\nshape = { sphere = 0.1 }\nat = [" + std::string(x) + ", -1, 0]\n"
            "[[joint]]\ntype = 'hinge'\nname = 'shaft'\na = 'world'\nb = 'ball'\nanchor = [0, 0, 0]\n"
            "axis = [0, 0, 1]\nmotor = { speed = 3.141592654, max = 8 }\n",
            "what = 'period'\nnear = 2\nwithin = 0.002\n");
        EXPECT_TRUE(r.passed) << x << ": " << r.value;
    }
}

TEST(ExpectationRun, ThatWasNotFinishedFails) {
    Stage stage(
        readScene(kFalling + "[[expect]]\nwhat = 'drift'\nbelow = 99\nafter = 0.5\n", "a", "a"));
    ExpectationChecker checker(stage);
    checker.look(stage);
    EXPECT_FALSE(checker.results().at(0).passed);
    EXPECT_NE(checker.results().at(0).text.find("never reached"), std::string::npos);
}

TEST(ExpectationRun, ThatEndedBeforeTheWindowClosesFails) {
    for (const char* what : {"what = 'position'\nof = 'ball'\nnear = [0, 9, 0]\nwithin = 99\n",
                             "what = 'spread'\nbelow = 99\n"}) {
        Stage stage(readScene(kFalling + "[[expect]]\nuntil = 0.8\n" + what, "a", "a"));
        ExpectationChecker checker(stage);
        checker.look(stage);
        EXPECT_FALSE(checker.results().at(0).passed) << what;
        EXPECT_NE(checker.results().at(0).text.find("the run ended before"), std::string::npos) << what;
    }
}

TEST(ExpectationRun, WhoseJointBreaksFails) {
    const std::string weak = "break_at = 1\n";
    const std::string window = "what = 'separation'\nbelow = 0.1\nafter = 0.5\n";
    EXPECT_TRUE(check(kSmallSwing, window).passed);
    const ExpectationResult broken = check(kSmallSwing + weak, window);
    EXPECT_FALSE(broken.passed);
    EXPECT_NE(broken.text.find("a joint broke"), std::string::npos) << broken.text;
}

}  // namespace
}  // namespace demos
