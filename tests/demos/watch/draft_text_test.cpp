// What a draft reports about changes.
#include "demos/watch/draft_text.h"

#include <gtest/gtest.h>

namespace {

using namespace demos;

/// 90 frames, 15 a second; sections from 0 and 2.9 s.
FilmPlan plan() {
    FilmPlan plan;
    plan.panels.resize(1);
    plan.panels[0].scene.hz = 60;
    Section rest, impact;
    rest.name = "rest";
    impact.at = 2.9;
    impact.name = "impact";
    plan.panels[0].scene.sections = {rest, impact};
    plan.fps = 15;
    plan.frames = 90;
    return plan;
}

Draft draft(std::vector<FrameSpan> changed) {
    Draft draft;
    draft.frames = draft.framesBefore = 90;
    draft.changed = std::move(changed);
    return draft;
}

TEST(DraftText, NamesFramesTimesAndSections) {
    EXPECT_EQ(changeText(draft({{44, 74}}), plan()),
              "frames 44 to 74 (2.93 to 4.93 s, section 'impact') changed");
    EXPECT_EQ(changeText(draft({{7, 7}}), plan()), "frame 7 (0.47 s, section 'rest') changed");
    EXPECT_EQ(changeText(draft({{40, 50}}), plan()),
              "frames 40 to 50 (2.67 to 3.33 s, sections 'rest', 'impact') changed");
    EXPECT_EQ(changeText(draft({}), plan()), "no frame changed");
}

/// 2.9 s is 43.5 frames: the first frame of the section is shown at 2.93 s, number 44.
TEST(DraftText, ASectionBeginsWithItsFirstFrame) {
    EXPECT_EQ(changeText(draft({{43, 43}}), plan()), "frame 43 (2.87 s, section 'rest') changed");
    EXPECT_EQ(changeText(draft({{44, 44}}), plan()), "frame 44 (2.93 s, section 'impact') changed");
}

TEST(DraftText, ManySpansAreCounted) {
    EXPECT_EQ(changeText(draft({{1, 1}, {3, 3}, {5, 6}, {9, 9}}), plan()),
              "5 frames in 4 spans of frames 1 to 9 (0.07 to 0.60 s, section 'rest') changed");
}

TEST(DraftText, ALengthThatDiffersIsReported) {
    Draft shorter = draft({});
    shorter.frames = 60;
    EXPECT_EQ(changeText(shorter, plan()), "the film has 60 frames, it had 90");
}

TEST(DraftText, TheFirstStepThatDiffersIsReported) {
    Draft moved = draft({{44, 89}});
    moved.firstStep = 174;
    moved.drawn = 46;
    moved.written = true;
    moved.pictured = 44;
    const std::vector<std::string> lines = draftLines(moved, plan(), {"out", true});
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines[1], "state differs from step 174 on (2.900 s)");
    EXPECT_EQ(lines[2], "wrote out/draft.png (frame 44, t = 2.933 s)");
    EXPECT_EQ(lines[3], "wrote out/draft.mp4 (90 frames, 46 drawn), open it");
    EXPECT_NE(draftJson(moved, plan(), {"out", true}).find(R"("first_step":174)"),
              std::string::npos);
}

TEST(DraftText, FailuresHaveTheirValueAndReason) {
    Draft bad = draft({});
    bad.failed = {{"drift of box* below 0.1 m", 0.25, "m", false, "it stands"}};
    bad.trouble = "tower: step 3: not finite";
    FilmPlan tower = plan();
    tower.name = "tower";
    EXPECT_EQ(
        failureLines(bad, tower),
        (std::vector<std::string>{"tower: failed: drift of box* below 0.1 m: 0.25 m (it stands)",
                                  "tower: step 3: not finite"}));
}

}  // namespace
