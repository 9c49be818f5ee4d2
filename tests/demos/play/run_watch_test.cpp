// What a run tells besides its result: bodies that fall out of the scene, gases, expectations.

#include "demos/play/run_watch.h"

#include <gtest/gtest.h>

#include "demos/play/warnings.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

/// The lines after `seconds`.
std::vector<std::string> linesOfRun(const std::string& seconds, const std::string& text) {
    Stage stage(read("seconds = " + seconds + "\n" + text));
    RunWatch watch(stage);
    const int steps = static_cast<int>(stage.scene.seconds * stage.scene.hz + 0.5);
    for (int i = 0; i < steps && stage.step(); ++i) watch.look(stage);
    return watch.lines(stage);
}

std::string fell(const std::string& seconds, const std::string& text) {
    return listed(linesOfRun(seconds, text));
}

const std::string kPlate =
    "[[body]]\nname = 'plate'\nshape = { box = [4, 1, 4] }\nfixed = true\n";
const std::string kBeside = "[[body]]\nname = 'b'\nshape = { sphere = 0.5 }\nat = [9, 2, 0]\n";

TEST(Falls, WithoutAFloorAreReportedAfterThreeSeconds) {
    EXPECT_EQ(fell("2.5", kBall), "");
    EXPECT_EQ(fell("4", kBall),
              "a: 'ball' falls out of the scene: 78.6 m below the start after 4 s; a floor is a body "
              "with shape = { plane = [0, 1, 0] } and fixed = true\n");
    EXPECT_EQ(fell("4", kFloor + kBall), "");
}

TEST(Falls, BesideAPlateAreReportedAHundredMetresBelowIt) {
    EXPECT_EQ(fell("4", kPlate + kBeside), "");
    EXPECT_NE(fell("5", kPlate + kBeside).find("below everything fixed after 5 s"), std::string::npos);
    EXPECT_EQ(fell("5", kPlate + kBall), "");
}

TEST(Falls, AreCountedInOneLine) {
    const std::vector<std::string> lines =
        linesOfRun("5", "[[repeat]]\ncount = 3\nstep = [2, 0, 0]\n"
                  "body = { name = 'box{i}', shape = { sphere = 0.5 } }\n");
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].starts_with("a: 'box0' and 2 other bodies fall out")) << lines[0];
}

TEST(Falls, FollowGravityWhereverItPoints) {
    EXPECT_NE(fell("5", "[world]\ngravity = [0, 9.81, 0]\n" + kBall), "");
    EXPECT_NE(fell("5", "[world]\ngravity = [-9.81, 0, 0]\n" + kPlate + kBeside), "");
}

TEST(Falls, AreNotWhatSomethingCarries) {
    EXPECT_EQ(fell("9", "[world]\ngravity = [0, 0, 0]\n" + kBall + "velocity = [0, -30, 0]\n"), "");
    // A parachute: at its final speed.
    EXPECT_EQ(fell("20", kBall + "mass = 1\n[[force]]\ntype = 'drag'\nlinear = 1\n"), "");
    // Thrown up: it comes down in time.
    EXPECT_EQ(fell("5", kBall + "velocity = [0, 20, 0]\n"), "");
    // A pendulum of a lift's length.
    EXPECT_EQ(fell("6", kBall + "[[joint]]\ntype = 'distance'\na = 'world'\nb = 'ball'\n"
                                "anchor_a = [40, 2, 0]\n"),
              "");
}

TEST(Falls, OfASensorBesideDoNotCountAsFixed) {
    EXPECT_NE(fell("4", "[[body]]\nname = 's'\nshape = { box = [1, 1, 1] }\nfixed = true\n"
                        "sensor = true\nat = [0, -200, 0]\n" + kBeside),
              "");
}

TEST(RunWatch, ReportsExpectationsThatFailed) {
    const std::string expect = "[[expect]]\nwhat = 'height'\nof = 'ball'\nabove = 1\n";
    EXPECT_EQ(fell("0.1", kFloor + kBall + expect), "");
    const std::vector<std::string> lines = linesOfRun("1", kFloor + kBall + expect);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].starts_with("a: the expectation failed: least height of ball above 1 m"))
        << lines[0];
    EXPECT_NE(lines[0].find(" m ('ball' at "), std::string::npos) << lines[0];
}

TEST(Warnings, NameABodyAsLightAsAir) {
    const auto lines = [](const std::string& text) { return warningsAtStart(Stage(read(text))); };
    EXPECT_EQ(lines(kBall + "density = 2.7\n"),
              (std::vector<std::string>{"a: 'ball': a density of 2.7 kg/m^3 is that of a gas; water "
                                        "has 1000, steel 7800"}));
    EXPECT_TRUE(lines(kBall + "density = 10\n").empty());
    const std::string foil = "[[material]]\nname = 'foil'\ndensity = 2.7\n";
    const std::vector<std::string> two =
        lines(foil + kBall + "material = 'foil'\n" + kBeside + "material = 'foil'\n");
    ASSERT_EQ(two.size(), 1u);
    EXPECT_TRUE(two[0].starts_with("a: 'ball' and 1 other body: a density of")) << two[0];
    // With a mass the density does not matter; a fixed body has none; a balloon floats in air.
    EXPECT_TRUE(lines(foil + kBall + "material = 'foil'\nmass = 2\n").empty());
    EXPECT_TRUE(lines(foil + kBall + "material = 'foil'\nfixed = true\n").empty());
    EXPECT_TRUE(lines(kBall + "density = 1\n[[force]]\ntype = 'medium'\ndensity = 1.2\n").empty());
    EXPECT_FALSE(lines(kBall + "density = 1\n[[force]]\ntype = 'medium'\ndensity = 1000\n").empty());
}

}  // namespace
}  // namespace demos::test
