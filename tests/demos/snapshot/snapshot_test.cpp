#include "demos/snapshot/snapshot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "demos/look/inks.h"
#include "demos/look/theme.h"
#include "demos/snapshot/player.h"
#include "demos/snapshot/scale.h"
#include "demos/text/stop.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

using test::sceneFrom;

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

const std::string kHangingBob = R"(format = 1
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

/// Two boxes on each other, the upper one 2 cm deep in the lower one.
const std::string kTwoBoxes = R"(format = 1
[[body]]
name = "lower"
shape = { box = [2, 1, 2] }
at = [0, 0.5, 0]
fixed = true
[[body]]
name = "upper"
shape = { box = [1, 1, 1] }
at = [0, 1.48, 0]
[camera]
from = [2, 2, 10]
look_at = [0, 1, 0]
)";

TEST(Snapshot, AnnotatesTheContactOfTheLargestImpulseAtItsNearestPoint) {
    Player player(sceneFrom(kTwoBoxes), {.annotate = true});
    player.step();
    const render::Frame frame = player.frame(0.1);
    const Overlays none;
    const std::size_t before = snapshot(player.stage(), none, 0.1, player.history()).arrows.size();
    ASSERT_EQ(frame.labels.size(), 5u);
    std::string names;
    for (const render::Label& label : frame.labels) {
        EXPECT_TRUE(label.beside);
        EXPECT_EQ(label.clearOf.size(), label.value.empty() ? 0u : 16u);
        names += label.text + label.subscript + (label.value.empty() ? " " : label.value + " ");
    }
    EXPECT_TRUE(names.starts_with("pa pb ra = ")) << names;
    EXPECT_TRUE(names.ends_with("n ")) << names;
    const render::Vec3& point = frame.labels[1].position;
    EXPECT_NEAR(point.x(), 0.5f, 0.02f);  // of four corners the one nearest to the camera
    EXPECT_NEAR(point.z(), 0.5f, 0.02f);
    ASSERT_EQ(frame.arrows.size(), before + 3);
    EXPECT_GT(frame.arrows.back().to.y(), point.y() + 0.1f);  // n: from the lower to the upper box
}

TEST(Snapshot, AnnotatesAJointWhereNothingTouches) {
    Player player(sceneFrom(kHangingBob), {.annotate = true});
    player.step();
    std::string names;
    for (const render::Label& label : player.frame(0.1).labels)
        names += label.text + label.subscript + label.value + " ";
    EXPECT_EQ(names, "pa pb rb = 1 m ");
}

TEST(Snapshot, CaptionIsTheTitleUntilASectionHasOne) {
    const Stage stage(sceneFrom(kBall));
    EXPECT_EQ(captionOf(snapshot(stage, {}, 0.0)), "a ball");
    EXPECT_EQ(captionOf(snapshot(stage, {}, 0.5)), "half a second in");
}

TEST(Snapshot, ACaptionStandsUnderItsSectionsName) {
    const Stage stage(sceneFrom(kBall + "[[section]]\nat = 0.6\nname = 'silent'\n"
                                        "[[section]]\nat = 0.8\nname = 'end'\ncaption = 'c'\n"));
    const auto headingAt = [&](double time) {
        const render::Frame frame = snapshot(stage, {}, time);
        EXPECT_EQ(frame.texts.size(), 1u);
        EXPECT_TRUE(frame.texts.at(0).plate);
        return frame.texts.at(0).heading;
    };
    EXPECT_EQ(headingAt(0.0), "");
    EXPECT_EQ(headingAt(0.7), "later");  // a section without a caption keeps the one before
    EXPECT_EQ(headingAt(0.9), "end");
}

TEST(Snapshot, HeadingsHaveContrastOnThePlateOfEveryTheme) {
    const Stage stage(sceneFrom(kBall));
    for (const std::string& theme : themeNames()) {
        const render::Frame frame = snapshot(stage, {.theme = theme}, 0.5);
        const render::Text& text = frame.texts.at(0);
        EXPECT_GE(contrast(text.headingColor, frame.look.plate), 4.5) << theme;
        EXPECT_GE(contrast(text.color, frame.look.plate), 7.0) << theme;
    }
}

TEST(Snapshot, TheFloorReflectsAsMuchAsTheSceneSays) {
    EXPECT_EQ(snapshot(Stage(sceneFrom(kBall)), {}, 0.5).look.reflection, 0.0f);
    SceneDescription scene = sceneFrom(kBall);
    scene.look.reflection = 0.25;
    scene.look.dither = true;
    const Stage glossy(scene);
    EXPECT_EQ(snapshot(glossy, {.theme = "dark"}, 0.5).look.reflection, 0.25f);
    EXPECT_TRUE(snapshot(glossy, {}, 0.5).look.dither);
}

TEST(Snapshot, TheFirstLineIsAPartOfStatisticsOnPaper) {
    const Stage stage(sceneFrom(kBall));
    const auto first = [&](const Overlays& overlays) {
        return snapshot(stage, overlays, 1.383).texts.at(0).text;
    };
    const std::string line = "t = 1.383 s   2 bodies   steady, 4 sub-steps";
    EXPECT_EQ(first({.stats = true, .pixelsPerPoint = 1.0}), line);
    EXPECT_NE(first({.pixelsPerPoint = 1.0}), line);
    EXPECT_NE(first({.stats = true}), line);  // the panel has the same
}

TEST(Snapshot, CleanPicturesHoldNoText) {
    const Stage stage(sceneFrom(kBall));
    Overlays clean;
    clean.text = false;
    clean.impulses = true;
    EXPECT_TRUE(snapshot(stage, clean, 0.0).texts.empty());
    EXPECT_TRUE(snapshot(stage, clean, 0.0).plates.empty());
}

TEST(Snapshot, TheCameraGoesAQuarterRoundInASecondAt90Degrees) {
    const Stage stage(sceneFrom(kBall));
    const render::Vec3 from = snapshot(stage, {}, 1.0).camera.from;
    EXPECT_NEAR(from.x(), 10.0f, 1e-5f);
    EXPECT_NEAR(from.y(), 2.0f, 1e-5f);
    EXPECT_NEAR(from.z(), 0.0f, 1e-5f);
}

TEST(Snapshot, AnArmReachesTheAnchorThatTheShapeDoesNot) {
    const Stage stage(sceneFrom(kHangingBob));
    const render::Frame frame = snapshot(stage, {}, 0.0);
    ASSERT_EQ(frame.rods.size(), 1u);  // none for the world
    EXPECT_NEAR((frame.rods[0].to - render::Vec3(0, 2, 0)).norm(), 0.0f, 1e-6f);
    EXPECT_NEAR((frame.rods[0].from - render::Vec3(1, 2, 0)).norm(), 0.0f, 1e-6f);
}

const render::PlateRow* rowOf(const render::Frame& frame, const std::string& name) {
    for (const render::Plate& plate : frame.plates)
        for (const render::PlateRow& row : plate.rows)
            if (row.name == name) return &row;
    return nullptr;
}

TEST(Snapshot, AnImpulseArrowIsAsLongAsItsLegendSays) {
    Player player(sceneFrom(kBall), {.impulses = true});
    player.step(60);
    const double impulse = player.stage().world.contacts()[0].impulse;
    EXPECT_NEAR(impulse, 2.0 * 9.81 / 60, 1e-3);  // m g dt: it rests
    History history;
    history.impulsePeak = 2.0 * impulse;  // 0.654 N s
    const render::Frame frame = snapshot(player.stage(), {.impulses = true}, 1.0, history);
    ASSERT_EQ(frame.arrows.size(), 1u);
    const render::PlateRow* row = rowOf(frame, "impulse");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->value, "0.5 N s");
    EXPECT_NEAR((frame.arrows[0].to - frame.arrows[0].from).norm() / row->meters, impulse / 0.5,
                1e-5);
}

TEST(Snapshot, ThePeakThatArrowsAreMeasuredByHalvesEveryHalfSecond) {
    History history;
    const Stage stage(sceneFrom(kHangingBob));  // no contacts
    history.impulsePeak = 64.0;
    for (int i = 0; i < 60; ++i) remember(stage, {}, history);  // 1 s
    EXPECT_NEAR(history.impulsePeak, 16.0, 1e-9);
}

TEST(Snapshot, ScalesAreRoundNumbers) {
    EXPECT_EQ(roundBelow(0.0), 0.0);
    EXPECT_EQ(roundAbove(0.0), 1.0);
    for (const double round : {1.0, 2.0, 5.0, 10.0, 200.0, 0.05, 1e-3}) {
        EXPECT_DOUBLE_EQ(roundBelow(round), round);
        EXPECT_DOUBLE_EQ(roundAbove(round), round);
    }
    EXPECT_EQ(roundBelow(4.9), 2.0);
    EXPECT_EQ(roundAbove(2.1), 5.0);
    EXPECT_EQ(roundAbove(60.0), 100.0);
    EXPECT_DOUBLE_EQ(roundBelow(0.019), 0.01);
}

TEST(Snapshot, ArrowsSuitTheSizeOfTheScene) {
    CameraDescription small, large;
    small.from = small.lookAt + Vec3(0, 0, 0.2);
    large.from = large.lookAt + Vec3(0, 0, 50);
    const ArrowScale a(3.0, viewHeight(small)), b(3.0, viewHeight(large));
    EXPECT_NEAR(b.longest / a.longest, 250.0, 1e-9);
    EXPECT_EQ(a.sample, b.sample);
    EXPECT_FALSE(a.shows(0.02 * a.longest));
    EXPECT_TRUE(a.shows(0.04 * a.longest));
}

TEST(Snapshot, ADotIsSmallBesideItsBody) {
    Player player(sceneFrom(kBall), {.contacts = true});
    player.step(30);
    const render::Frame frame = player.frame(0.5);
    ASSERT_EQ(frame.markers.size(), 1u);
    EXPECT_GT(frame.markers[0].largest, 0.0f);
    EXPECT_LT(frame.markers[0].largest, 0.25f * 0.5f);
}

TEST(Snapshot, GhostsAreWhereTheBodyWas) {
    const Overlays overlays{.ghost = true, .ghostEvery = 0.1};
    Player player(sceneFrom(kHangingBob), overlays);
    std::vector<Vec3> was;
    for (int step = 0; step <= 30; ++step) {
        if (step > 0) player.step();
        if (step % 6 == 0) was.push_back(player.stage().world.pose({0}).position);
    }
    const render::Frame frame = player.frame(0.5);
    ASSERT_GE(frame.ghosts.size(), 2u);
    float before = 0.0f;
    for (const render::Solid& ghost : frame.ghosts) {
        EXPECT_TRUE(std::any_of(was.begin(), was.end(), [&](const Vec3& at) {
            return (at.cast<float>() - ghost.position).norm() < 1e-6f;
        }));
        EXPECT_GT(ghost.color.a, before);  // the newest is the densest
        before = ghost.color.a;
    }
    EXPECT_LT(before, 0.5f);
}

TEST(Snapshot, WhatRestsHasNoGhosts) {
    Player player(sceneFrom(kBall), {.ghost = true, .ghostEvery = 0.1});
    player.step(60);
    EXPECT_TRUE(player.frame(1.0).ghosts.empty());
}

TEST(Snapshot, NamesStandAtTheCentresAndPlanesHaveNone) {
    const Stage stage(sceneFrom(kBall));
    const render::Frame frame = snapshot(stage, {.ids = true}, 0.0);
    ASSERT_EQ(frame.labels.size(), 1u);
    EXPECT_EQ(frame.labels[0].text, "ball");
    EXPECT_FLOAT_EQ(frame.labels[0].position.y(), 0.5f);
    EXPECT_FLOAT_EQ(frame.labels[0].reach, 0.5f);
}

TEST(Snapshot, ABoundingBoxHasTwelveEdgesAndACentreOneMark) {
    const Stage stage(sceneFrom(kBall));
    const render::Frame frame = snapshot(stage, {.com = true, .bounds = true}, 0.0);
    EXPECT_EQ(frame.lines.size(), 12u);
    for (const render::Line& line : frame.lines)
        EXPECT_NEAR((line.to - line.from).norm(), 1.0f, 1e-6f);
    ASSERT_EQ(frame.markers.size(), 1u);
    EXPECT_EQ(frame.markers[0].shape, render::MarkerShape::quartered);
}

TEST(Snapshot, TheStatisticsSplitEnergyIntoABar) {
    Player player(sceneFrom(kHangingBob), {.stats = true});
    player.step(20);
    const render::Frame frame = player.frame(1.0 / 3.0);
    const render::PlateRow* energy = rowOf(frame, "energy");
    ASSERT_NE(energy, nullptr);
    ASSERT_EQ(energy->bar.size(), 2u);
    EXPECT_GT(energy->bar[0].share, 0.1f);
    EXPECT_LE(energy->bar[0].share + energy->bar[1].share, 1.0f + 1e-6f);
    EXPECT_EQ(rowOf(frame, "time")->value, "0.333 s");
    EXPECT_EQ(rowOf(frame, "step")->value, "20");
    EXPECT_EQ(rowOf(frame, "solver")->value, "steady impulses");
    ASSERT_EQ(frame.texts.size(), 1u);  // the caption
    EXPECT_EQ(frame.texts[0].text, "test");
}

TEST(Snapshot, TheLegendNamesWhatIsShown) {
    const Stage stage(sceneFrom(kBall));
    const render::Frame frame =
        snapshot(stage, {.contacts = true, .nudges = true, .com = true}, 0.0);
    EXPECT_NE(rowOf(frame, "contact"), nullptr);
    EXPECT_NE(rowOf(frame, "centre of mass"), nullptr);
    ASSERT_NE(rowOf(frame, "nudge"), nullptr);
    EXPECT_EQ(rowOf(frame, "nudge")->value, "none");
    EXPECT_EQ(rowOf(frame, "impulse"), nullptr);
}

TEST(Snapshot, TrailsFollowTheSteps) {
    Player player(sceneFrom(kBall), {});
    EXPECT_TRUE(player.frame(0.0).trails.empty());  // a single point is not a path
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

TEST(Snapshot, ThemesChangeTheInkOfPlainTextAndPlates) {
    const Stage stage(sceneFrom(kBall));
    Overlays overlays{.impulses = true};
    const render::Frame studio = snapshot(stage, overlays, 0.0);
    overlays.theme = "dark";
    const render::Frame dark = snapshot(stage, overlays, 0.0);
    EXPECT_GT(dark.texts.at(0).color.r, 0.8f);
    EXPECT_GT(dark.look.ink.r, 0.8f);
    EXPECT_LT(dark.look.plate.r, 0.3f);
    EXPECT_EQ(rowOf(dark, "impulse")->color.r, rowOf(studio, "impulse")->color.r);
    EXPECT_LT(dark.look.skyTop.r, studio.look.skyTop.r);
}

TEST(Snapshot, ARemovedBodyIsNeitherDrawnNorCounted) {
    const std::string far = "[[body]]\nname = 'far'\nshape = { sphere = 0.5 }\n"
                            "at = [99990, 5, 0]\nvelocity = [9000, 0, 0]\n";
    Overlays overlays;
    overlays.ids = overlays.stats = true;
    Player player(sceneFrom(kBall + far), overlays);
    EXPECT_EQ(player.frame(0.0).solids.size(), 2u);
    player.step();
    const render::Frame frame = player.frame(1.0 / 60);
    EXPECT_EQ(frame.solids.size(), 1u);
    EXPECT_EQ(frame.labels.size(), 1u);
    EXPECT_EQ(rowOf(frame, "bodies")->value, "2");
    ASSERT_EQ(player.incidents().size(), 1u);
    EXPECT_EQ(bodyAndStep(player.incidents().front()), "'far', step 1");
}

/// Its path would be followed with a body that is no longer there.
TEST(Snapshot, AKinematicBodyMayGoTooFar) {
    Player player(sceneFrom("format = 1\n[[body]]\nname = 'cart'\nshape = { sphere = 0.5 }\n"
                            "at = [99990, 0, 0]\nkinematic = { velocity = [9000, 0, 0] }\n"),
                  Overlays{});
    player.step(3);
    EXPECT_EQ(player.stage().bodiesNow(), 0);
    EXPECT_EQ(player.incidents().size(), 1u);
}

}  // namespace
}  // namespace demos
