// States of an unfinished film: what a killed run continues from.
#include "demos/film/resume_states.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "demos/film/film_options.h"
#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

namespace fs = std::filesystem;

class ResumedFilm : public testing::Test {
protected:
    ResumedFilm() {
        options_.scenes = {"stack"};
        options_.quality = "low";
        options_.fps = 30;
        options_.outputs = {folder_.path().string()};
    }
    FilmPlan planned() const {
        FilmPlan plan = planFilm(options_);
        planToResume(outputsOf(plan, options_), options_, plan);
        return plan;
    }
    std::set<std::string> names() const {
        std::set<std::string> all;
        if (fs::exists(folder_ / ".impulse-resume"))
            for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / ".impulse-resume"))
                all.insert(entry.path().filename().string());
        return all;
    }
    /// The film's hash at `frame`, of a run that keeps states `every` s.
    std::uint64_t play(const FilmPlan& plan, int frame, double every) const {
        Composite composite(plan);
        ResumeStates states(plan, every);
        for (int i = composite.startBefore(frame); i < frame; ++i) {
            states.begin();
            composite.advance(false);
            states.end(composite);
        }
        return composite.hash();
    }

    support::TemporaryFolder folder_;
    FilmOptions options_;
};

TEST_F(ResumedFilm, ContinuesFromALateStateToTheSameBits) {
    const FilmPlan first = planned();
    EXPECT_TRUE(first.states.empty());
    play(first, 10, 0.0);
    removeStatesBefore(9, first);
    EXPECT_EQ(names(), (std::set<std::string>{"000018.state", "000020.state"}));
    const FilmPlan again = planned();
    EXPECT_EQ(Composite(again).startBefore(12), 10);
    EXPECT_EQ(Composite(again).startBefore(9), 9);
    EXPECT_EQ(Composite(again).startBefore(5), 0) << "the older ones are gone";
    EXPECT_EQ(play(again, 20, 1e9), play(first, 20, 1e9));
    clearStates(again);
    EXPECT_FALSE(fs::exists(folder_ / ".impulse-resume"));
}

TEST_F(ResumedFilm, LeavesWhatAKilledRunWasWritingNowhere) {
    const FilmPlan plan = planned();
    fs::create_directories(plan.resume);
    for (const char* name : {"000018.state", "1000000.state.tmp77", "camera.state", "camera.state.tmp1"})
        std::ofstream(fs::path(plan.resume) / name) << "old";
    clearStates(plan);
    EXPECT_FALSE(fs::exists(plan.resume));
}

TEST_F(ResumedFilm, WithMotionBlurNeedsTheFrameBefore) {
    options_.blur = 4;
    const FilmPlan plan = planned();
    play(plan, 10, 0.0);
    removeStatesBefore(9, plan);
    EXPECT_EQ(names(), (std::set<std::string>{"000016.state", "000018.state", "000020.state"}));
}

TEST_F(ResumedFilm, ThatTakesNoTimeLeavesNothing) {
    play(planned(), 10, 1e9);
    EXPECT_TRUE(names().empty());
}

TEST_F(ResumedFilm, TakesNoStatesOfOtherValuesAndNoneIfItIsReplaced) {
    play(planned(), 10, 0.0);
    options_.overrides = {"solver.sweeps=7"};
    FilmPlan other = planned();
    EXPECT_EQ(Composite(other).startBefore(12), 0);
    options_.overrides.clear();
    options_.overwrite = true;
    EXPECT_TRUE(planned().states.empty());
}

TEST_F(ResumedFilm, LeavesForeignFilesAndFollowsNoLink) {
    play(planned(), 10, 0.0);
    for (const char* name : {"mine.txt", "mine.state"})
        std::ofstream(folder_ / ".impulse-resume" / name) << "mine";
    clearStates(planned());
    EXPECT_EQ(names(), (std::set<std::string>{"mine.state", "mine.txt"}));
    const support::TemporaryFolder elsewhere;
    std::ofstream(elsewhere / "000002.state") << "foreign";
    fs::remove_all(folder_ / ".impulse-resume");
    fs::create_directory_symlink(elsewhere.path(), folder_ / ".impulse-resume");
    const FilmPlan plan = planned();
    play(plan, 10, 0.0);
    clearStates(plan);
    EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere.path()), fs::directory_iterator()), 1);
}

TEST_F(ResumedFilm, HasStatesOnlyNextToFrames) {
    EXPECT_FALSE(planned().resume.empty());
    options_.shard = Shard{3, 16};
    EXPECT_TRUE(planned().resume.ends_with(".impulse-resume.003-of-016"));
    options_.shard.reset();
    options_.frames = "100..200";
    EXPECT_TRUE(planned().resume.empty());
    options_.frames.clear();
    options_.outputs = {(folder_ / "a.mp4").string()};
    EXPECT_TRUE(planned().resume.empty());
}

}  // namespace
}  // namespace demos::test
