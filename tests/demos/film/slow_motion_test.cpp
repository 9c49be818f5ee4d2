#include "demos/film/slow_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace demos::test {
namespace {

/// A run of 4 s at 60 steps a second; section i begins at[i] (s).
SceneDescription sceneWith(const std::vector<std::pair<double, double>>& sections) {
    SceneDescription scene;
    scene.seconds = 4.0;
    scene.hz = 60;
    for (const auto& [at, slow] : sections) {
        Section section;
        section.at = at, section.slow = slow;
        scene.sections.push_back(section);
    }
    return scene;
}

TEST(SlowMotion, OfASectionEndsWithIt) {
    const SceneDescription scene = sceneWith({{1.0, 0.25}, {1.5, 1.0}, {3.0, 2.0}});
    EXPECT_TRUE(hasSlowMotion(scene));
    EXPECT_DOUBLE_EQ(filmTimeAt(0.5, scene), 0.5);
    EXPECT_DOUBLE_EQ(filmTimeAt(1.25, scene), 2.0);
    EXPECT_DOUBLE_EQ(filmTimeAt(2.0, scene), 3.5);
    EXPECT_DOUBLE_EQ(filmTimeAt(4.0, scene), 5.0);
    const std::vector<int> steps = stepsOfFrames(scene, 20, 100);
    ASSERT_EQ(steps.size(), 101u);
    EXPECT_EQ(steps[20], 60);                        // 1 s: three steps a frame until here
    EXPECT_EQ(steps[24] - steps[20], 3);             // three quarters of a step a frame
    EXPECT_EQ(steps[60], 90);                        // 3 s: the end of the section
    EXPECT_EQ(steps[61], 93);
    EXPECT_EQ(steps[91] - steps[90], 6);             // a time lapse
    EXPECT_EQ(steps[100], 240);
    EXPECT_TRUE(std::ranges::is_sorted(steps));
}

TEST(SlowMotion, IsNotThereWhereEverySectionHasItsSpeed) {
    EXPECT_FALSE(hasSlowMotion(sceneWith({})));
    EXPECT_FALSE(hasSlowMotion(sceneWith({{0.0, 1.0}, {2.0, 1.0}})));
    EXPECT_FALSE(hasSlowMotion(sceneWith({{4.0, 0.5}})));  // after the run
    EXPECT_TRUE(jerkySections(sceneWith({{0.0, 1.0}}), 60).empty());
}

/// Every step once at the frame rate that the step allows, whatever the speed.
TEST(SlowMotion, ShowsEachStepOnceWhereThereIsOneAFrame) {
    for (const double slow : {0.5, 1.0 / 3.0, 0.25, 0.1}) {
        SceneDescription scene = sceneWith({{0.0, slow}});
        scene.hz = static_cast<int>(std::lround(20 / slow));
        const int frames = static_cast<int>(std::lround(20 * filmTimeAt(4.0, scene)));
        const std::vector<int> steps = stepsOfFrames(scene, 20, frames);
        for (int frame = 0; frame < frames; ++frame) ASSERT_EQ(steps[frame], frame) << slow;
        EXPECT_TRUE(jerkySections(scene, 20).empty()) << slow;
    }
}

TEST(SlowMotion, WithoutEnoughStepsIsReportedWithARateThatIsSmooth) {
    const SceneDescription scene = sceneWith({{1.0, 0.25}});
    const std::vector<std::string> lines = jerkySections(scene, 30);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0], "the section at 1 s: slow = 0.25 shows each step in 2 frames; with --set "
                        "world.hz=120 each frame has its own");
    SceneDescription smooth = scene;
    smooth.hz = 120;
    EXPECT_TRUE(jerkySections(smooth, 30).empty());
}

}  // namespace
}  // namespace demos::test
