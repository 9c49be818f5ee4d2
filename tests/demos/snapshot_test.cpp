#include "demos/snapshot.h"

#include <gtest/gtest.h>

#include "demos/player.h"
#include "demos/scene/reader.h"
#include "demos/stop.h"

namespace demos {
namespace {

SceneDescription sceneFrom(const std::string& text) { return readScene(text, "test", "test"); }

const std::string kBall = R"(format = 1
title = "a ball"
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [0, 0.5, 0]
mass = 2.0
[camera]
from = [0, 2, 10]
look_at = [0, 1, 0]
orbit_deg_per_s = 90
[look]
trails = ["ball"]
[[section]]
at = 0.5
name = "later"
caption = "half a second in"
)";

const std::string kPendulum = R"(format = 1
[[body]]
name = "bob"
shape = { sphere = 0.1 }
at = [1, 2, 0]
[[joint]]
type = "ball"
a = "world"
b = "bob"
anchor = [0, 2, 0]
)";

std::string captionOf(const render::Frame& frame) {
    for (const render::Text& text : frame.texts)
        if (text.corner == render::Corner::bottomLeft) return text.text;
    return {};
}

TEST(Snapshot, ShowsPlanesAsGroundAndBodiesAsSolids) {
    const Stage stage(sceneFrom(kBall));
    const render::Frame frame = snapshot(stage, {}, 0.0);
    ASSERT_EQ(frame.grounds.size(), 1u);
    ASSERT_EQ(frame.solids.size(), 1u);
    EXPECT_EQ(frame.solids[0].shape, render::SolidShape::sphere);
    EXPECT_FLOAT_EQ(frame.solids[0].position.y(), 0.5f);
}

TEST(Snapshot, CaptionIsTheTitleUntilASectionHasOne) {
    const Stage stage(sceneFrom(kBall));
    EXPECT_EQ(captionOf(snapshot(stage, {}, 0.0)), "a ball");
    EXPECT_EQ(captionOf(snapshot(stage, {}, 0.5)), "half a second in");
}

TEST(Snapshot, TimeIsWrittenInTheCorner) {
    const Stage stage(sceneFrom(kBall));
    EXPECT_EQ(snapshot(stage, {}, 1.383).texts.at(0).text,
              "t = 1.383 s   2 bodies   steady, 4 sub-steps");
}

TEST(Snapshot, CleanPicturesHoldNoText) {
    const Stage stage(sceneFrom(kBall));
    Overlays clean;
    clean.text = false;
    EXPECT_TRUE(snapshot(stage, clean, 0.0).texts.empty());
}

TEST(Snapshot, TheCameraGoesAQuarterRoundInASecondAt90Degrees) {
    const Stage stage(sceneFrom(kBall));
    const render::Vec3 from = snapshot(stage, {}, 1.0).camera.from;
    EXPECT_NEAR(from.x(), 10.0f, 1e-5f);
    EXPECT_NEAR(from.y(), 2.0f, 1e-5f);
    EXPECT_NEAR(from.z(), 0.0f, 1e-5f);
}

TEST(Snapshot, AnArmReachesTheAnchorThatTheShapeDoesNot) {
    const Stage stage(sceneFrom(kPendulum));
    const render::Frame frame = snapshot(stage, {}, 0.0);
    ASSERT_EQ(frame.rods.size(), 1u);  // none for the world
    EXPECT_NEAR((frame.rods[0].to - render::Vec3(0, 2, 0)).norm(), 0.0f, 1e-6f);
    EXPECT_NEAR((frame.rods[0].from - render::Vec3(1, 2, 0)).norm(), 0.0f, 1e-6f);
}

TEST(Snapshot, AnImpulseArrowIsAsLongAsItsLegendSays) {
    Player player(sceneFrom(kBall), {.impulses = true});
    player.step(60);
    const double impulse = player.stage().world.contacts()[0].impulse;
    EXPECT_NEAR(impulse, 2.0 * 9.81 / 60, 1e-3);  // m g dt: it rests
    History history;
    history.largestImpulse = 2.0 * impulse;  // arrows are 2 m at most, so the scale is 0.5
    const render::Frame frame = snapshot(player.stage(), {.impulses = true}, 1.0, history);
    ASSERT_EQ(frame.arrows.size(), 1u);
    EXPECT_EQ(frame.texts.at(2).text, "arrow 1 m = 0.5 N s");
    EXPECT_NEAR((frame.arrows[0].to - frame.arrows[0].from).norm(), impulse / 0.5, 1e-5);
}

TEST(Snapshot, ScalesAreRoundNumbers) {
    EXPECT_EQ(arrowScale(0.0), 1.0);
    EXPECT_EQ(arrowScale(1.0), 1.0);
    EXPECT_EQ(arrowScale(2.0), 2.5);
    EXPECT_EQ(arrowScale(3.0), 5.0);
    EXPECT_EQ(arrowScale(60.0), 100.0);
    EXPECT_DOUBLE_EQ(arrowScale(0.02), 0.025);
}

TEST(Snapshot, TrailsFollowTheSteps) {
    Player player(sceneFrom(kBall), {});
    EXPECT_TRUE(player.frame(0.0).trails.empty());  // a point is no path yet
    player.step(5);
    ASSERT_EQ(player.frame(0.1).trails.size(), 1u);
    EXPECT_EQ(player.frame(0.1).trails[0].points.size(), 6u);
}

TEST(Snapshot, WatchingNudgesDoesNotChangeTheMotion) {
    Player plain(sceneFrom(kBall), {}), watched(sceneFrom(kBall), {.nudges = true});
    plain.step(30);
    watched.step(30);
    EXPECT_EQ(plain.stage().world.hash(), watched.stage().world.hash());
}

TEST(Snapshot, ThemesChangeTheInkOfPlainTextOnly) {
    const Stage stage(sceneFrom(kBall));
    Overlays overlays{.impulses = true};
    const render::Frame studio = snapshot(stage, overlays, 0.0);
    overlays.theme = "dark";
    const render::Frame dark = snapshot(stage, overlays, 0.0);
    EXPECT_GT(dark.texts.at(0).color.r, 0.8f);
    EXPECT_EQ(dark.texts.at(2).color.r, studio.texts.at(2).color.r);
    EXPECT_LT(dark.look.skyTop.r, studio.look.skyTop.r);
}

}  // namespace
}  // namespace demos
