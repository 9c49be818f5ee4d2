// The Markdown of --summary: what a page of a job shows.
#include "demos/regression/markdown_summary.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

/// Sets variables of the environment, and puts them back.
class MarkdownSummary : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"GITHUB_ACTIONS", "GITLAB_CI", "GITHUB_STEP_SUMMARY"}) unset(name);
    }
    void TearDown() override {
        for (const auto& [name, value] : before_)
            value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
    }
    void set(const char* name, const std::string& value) {
        remember(name);
        setenv(name, value.c_str(), 1);
    }
    void unset(const char* name) {
        remember(name);
        unsetenv(name);
    }

private:
    void remember(const char* name) {
        const char* value = std::getenv(name);
        before_.try_emplace(name, value ? value : "");
    }
    std::map<std::string, std::string> before_;
};

TestVerdict failedTower(const std::string& folder) {
    PictureVerdict picture;
    picture.time = 2.5;
    picture.kind = PictureVerdict::Kind::changed;
    picture.difference.differing = 345;
    picture.baseline = folder + "/scenes/tower.snapshots/t2.5.png";
    picture.actual = folder + "/output/test/tower.snapshots/t2.5.png";
    SceneVerdict scene;
    scene.name = "tower";
    scene.state = SceneVerdict::State::failed;
    scene.physics.lines = {"a *line* | with <markup>"};
    scene.pictures = {picture};
    SceneVerdict good;
    good.name = "wall";
    TestVerdict verdict;
    verdict.scenes = {scene, good};
    return verdict;
}

void expectHas(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
}

TEST_F(MarkdownSummary, SaysWhatFailedAndNothingOfWhatPassed) {
    const TestVerdict verdict = failedTower("/checkout");
    const std::string text = markdownSummary(verdict, {"/checkout", "", ""});
    EXPECT_EQ(text.find("### impulse test: 2 scenes: 1 passed, 1 failed\n"), 0u) << text;
    expectHas(text, "#### tower: failed\n");
    expectHas(text, "a \\*line\\* \\| with \\<markup\\>");
    expectHas(text, "345 pixels differ");
    expectHas(text, "impulse approve tower");
    EXPECT_EQ(text.find("wall"), std::string::npos) << text;
}

TEST_F(MarkdownSummary, OnGitHubShowsTheCommittedPictureAndNamesTheOther) {
    set("GITHUB_ACTIONS", "true");
    set("GITHUB_WORKSPACE", "/checkout");
    set("GITHUB_SERVER_URL", "https://github.com");
    set("GITHUB_REPOSITORY", "me/towers");
    set("GITHUB_SHA", "abc");
    const std::string text = markdownSummary(failedTower("/checkout"), pictureLinks("s.md"));
    expectHas(text, "| ![t2.5.png](https://github.com/me/towers/raw/abc/scenes/"
                    "tower.snapshots/t2.5.png) | output/test/tower.snapshots/t2.5.png |");
}

TEST_F(MarkdownSummary, OnGitLabShowsBothPictures) {
    set("GITLAB_CI", "true");
    set("CI_PROJECT_DIR", "/checkout");
    set("CI_PROJECT_URL", "https://gitlab.com/me/towers");
    set("CI_COMMIT_SHA", "abc");
    set("CI_JOB_ID", "77");
    const std::string text = markdownSummary(failedTower("/checkout"), pictureLinks("s.md"));
    expectHas(text, "(https://gitlab.com/me/towers/-/raw/abc/scenes/tower.snapshots/t2.5.png)");
    expectHas(text, "(https://gitlab.com/me/towers/-/jobs/77/artifacts/raw/output/test/"
                    "tower.snapshots/t2.5.png)");
}

TEST_F(MarkdownSummary, ElsewhereNamesArePlacesBesideIt) {
    const std::string text =
        markdownSummary(failedTower("/my check(out)"), pictureLinks("/my check(out)/out/s.md"));
    expectHas(text, "(./../scenes/tower.snapshots/t2.5.png)");
    const std::string outside =
        markdownSummary(failedTower("/else (where)"), pictureLinks("/out/s.md"));
    expectHas(outside, "(./../else%20%28where%29/scenes/tower.snapshots/t2.5.png)");
}

TEST_F(MarkdownSummary, KeepsWhatTheStepHasWritten) {
    const support::TemporaryFolder folder;
    const std::string file = (folder / "summary.md").string();
    const auto content = [&file] {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    };
    writeSummary(file, "one\n");
    writeSummary(file, "two\n");
    EXPECT_EQ(content(), "two\n");
    set("GITHUB_STEP_SUMMARY", file);
    writeSummary(file, "three\n");
    EXPECT_EQ(content(), "two\n\nthree\n");
}

TEST_F(MarkdownSummary, OfThousandsOfFailuresIsNotTooLarge) {
    TestVerdict verdict = failedTower("/checkout");
    verdict.scenes.resize(1);
    verdict.scenes[0].physics.lines[0].resize(2000, 'x');
    verdict.scenes.resize(1000, verdict.scenes[0]);
    const std::string text = markdownSummary(verdict, {"/checkout", "", ""});
    EXPECT_LT(text.size(), kMostSummary + 1000);
    EXPECT_GT(text.size(), kMostSummary / 2);
    expectHas(text, "scenes more: see report.html");
}

}  // namespace
}  // namespace demos::test
