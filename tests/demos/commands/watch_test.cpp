// impulse watch: what it reports and draws when a file is saved.
#include <nlohmann/json.hpp>

#include "tests/demos/commands/conversation.h"
#include "tests/demos/small_film.h"

namespace demos::test {

using Json = nlohmann::json;

namespace {

/// A ball that falls through two sections.
const std::string kFall = R"(format = 1
seconds = 2.0
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [0, 3, 0]
[camera]
from = [8, 5, 14]
[[section]]
at = 0.0
name = "fall"
[[section]]
at = 1.0
name = "late"
caption = "late"
)";

class Watch : public testing::Test {
protected:
    Watch() { write(folder / "my.toml", kFall); }

    Launch launch(std::vector<std::string> more) const {
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = {"watch", "my.toml", "--size", "96x54"};
        launch.arguments.insert(launch.arguments.end(), more.begin(), more.end());
        return launch;
    }
    /// Saves as editors do: writes another file and renames it.
    void replace(const std::string& name, const std::string& text) const {
        write(folder / (name + "~"), text);
        fs::rename(folder / (name + "~"), folder / name);
    }
    fs::path made(const std::string& name) const { return folder / "output/my" / name; }

    TemporaryFolder folder;
};

std::string replaced(std::string text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), now);
}

Json draftIn(const std::string& lines) {
    const std::size_t at = lines.find("{\"event\":\"draft\"");
    EXPECT_NE(at, std::string::npos) << lines;
    return at == lines.npos ? Json() : Json::parse(lines.substr(at, lines.find('\n', at) - at));
}

constexpr int kDraftFrames = 30;  // 2 s at 15 frames/s

TEST_F(Watch, OneDraftIsAFilmAndAPicture) {
    const Ended ended = run(launch({"--once"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(isWhole(contentOf(made("draft.png"))));
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    EXPECT_EQ(playableFrames(made("draft.mp4")), kDraftFrames);
    EXPECT_NE(ended.out.find("wrote output/my/draft.mp4 (30 frames, 30 drawn), open it"),
              std::string::npos)
        << ended.out;
}

TEST_F(Watch, DrawsAnewWhatASaveChangesAndNothingElse) {
    Conversation watching(launch({"--json"}));
    EXPECT_EQ(draftIn(watching.until("\"watching\""))["drawn"], kDraftFrames);
    // A new caption of the second section, visible from 1 s on: frames 15 to 29. The state stays.
    write(folder / "my.toml",
          replaced(kFall, "\"late\"\ncaption = \"late\"", "\"late\"\ncaption = \"later\""));
    Json draft = draftIn(watching.until("\"draft\""));
    EXPECT_EQ(draft["drawn"], 15) << draft;
    EXPECT_EQ(draft["changed"],
              (Json::array({{{"first", 15}, {"last", 29}, {"sections", {"late"}}}})));
    EXPECT_TRUE(draft["first_step"].is_null()) << draft;
    EXPECT_EQ(draft["picture"], "output/my/draft.png");
    // New gravity changes the state of every step except the start, so every frame except the
    // first, whose picture stays the same. Saved by renaming.
    replace("my.toml",
            replaced(kFall, "[[section]]", "[world]\ngravity = [0, -5, 0]\n[[section]]"));
    draft = draftIn(watching.until("\"draft\""));
    EXPECT_EQ(draft["drawn"], kDraftFrames - 1) << draft;
    EXPECT_EQ(draft["first_step"], 1) << draft;
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

TEST_F(Watch, NamesTheFirstStepAndTheFirstFrame) {
    Conversation watching(launch({"--json"}));
    watching.until("\"watching\"");
    replace("my.toml", replaced(kFall, "at = [0, 3, 0]", "at = [0, 3, 0]\nvelocity = [1, 0, 0]"));
    const Json draft = draftIn(watching.until("\"draft\""));
    EXPECT_EQ(draft["drawn"], kDraftFrames - 1) << draft;  // frame 0 is at rest in both
    EXPECT_EQ(draft["changed"][0]["first"], 1);
    EXPECT_EQ(draft["first_step"], 0);  // the velocity is part of the state
    EXPECT_EQ(watching.endBy(SIGTERM), 130);
}

TEST_F(Watch, SaysWhenNothingChanged) {
    Conversation watching(launch({}));
    const std::string first = watching.until("watching my.toml");
    EXPECT_NE(first.find("open it"), std::string::npos) << first;
    const auto written = fs::last_write_time(made("draft.png"));
    replace("my.toml", "# another word\n" + kFall);
    EXPECT_EQ(watching.until("\n"), "no frame changed\n");
    EXPECT_EQ(fs::last_write_time(made("draft.png")), written);
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

TEST_F(Watch, ErrorsAreReportedOnceAndWatchingGoesOn) {
    Conversation watching(launch({}));
    watching.until("watching my.toml");
    write(folder / "my.toml", "format = 1\nsecond = 2\n");
    EXPECT_NE(watching.until("my.toml:2:1").find("impulse: my.toml:2:1: "), std::string::npos);
    replace("my.toml", kFall);
    EXPECT_NE(watching.until("no frame changed").find("no frame changed"), std::string::npos);
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

TEST_F(Watch, FilesThatTheSceneReadsAreWatched) {
    const auto part = [](const std::string& radius) {
        return "<mujocoinclude><worldbody><body pos='0 0 3'><freejoint/><geom size='" + radius +
               "'/></body></worldbody></mujocoinclude>";
    };
    write(folder / "part.xml", part("0.2"));
    write(
        folder / "my.xml",
        "<mujoco><include file='part.xml'/><worldbody><geom type='plane' size='0 0 1'/></worldbody>"
        "</mujoco>");
    Launch model = launch({"--json", "--seconds", "2"});
    model.arguments[1] = "my.xml";
    Conversation watching(model);
    EXPECT_NE(watching.until("\"watching\"").find("\"files\":2"), std::string::npos);
    replace("part.xml", part("0.3"));
    EXPECT_EQ(draftIn(watching.until("\"draft\""))["drawn"], kDraftFrames);
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

TEST_F(Watch, WhatASceneIncludesIsWatchedOnceItIsIncluded) {
    const auto part = [](const std::string& radius) {
        return "format = 1\n[[body]]\nname = \"b\"\nshape = { sphere = " + radius +
               " }\nat = [2, 1, 0]\n";
    };
    Conversation watching(launch({"--json"}));
    EXPECT_NE(watching.until("\"watching\"").find("\"files\":1"), std::string::npos);
    write(folder / "part.toml", part("0.2"));
    replace("my.toml", replaced(kFall, "seconds", "include = [\"part.toml\"]\nseconds"));
    EXPECT_EQ(draftIn(watching.until("\"draft\""))["drawn"], kDraftFrames);
    replace("part.toml", part("0.3"));
    EXPECT_EQ(draftIn(watching.until("\"draft\""))["drawn"], kDraftFrames);
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

TEST_F(Watch, AFailedExpectationIsReported) {
    write(folder / "my.toml",
          kFall + "[[expect]]\nwhat = \"speed\"\nof = [\"ball\"]\nbelow = 1\nwhy = \"slow\"\n");
    const Ended ended = run(launch({"--once"}));
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("impulse: my: failed: largest speed of ball below 1 m/s"), std::string::npos)
        << ended.err;
    EXPECT_NE(ended.err.find("(slow)"), std::string::npos) << ended.err;
    EXPECT_TRUE(fs::exists(made("draft.png")));
}

TEST_F(Watch, WithoutFfmpegThereAreFramesAndAStrip) {
    Launch without = launch({});
    without.beforeExec = [] { setenv("PATH", "/nonexistent", 1); };
    Conversation watching(without);
    const std::string first = watching.until("watching my.toml");
    EXPECT_NE(first.find("ffmpeg is not installed"), std::string::npos) << first;
    EXPECT_NE(first.find("output/my/draft_strip.png"), std::string::npos) << first;
    EXPECT_EQ(framesIn(made("draft")).size(), static_cast<std::size_t>(kDraftFrames));
    const Files before = framesIn(made("draft"));
    replace("my.toml", replaced(kFall, "seconds = 2.0", "seconds = 1.0"));
    watching.until("it had 30");
    watching.until("open it");
    const Files after = framesIn(made("draft"));
    EXPECT_EQ(after.size(), 15u);
    for (const auto& [name, png] : after) EXPECT_EQ(png, before.at(name)) << name;
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

/// As `git checkout` does: a folder disappears with its content and comes back.
TEST_F(Watch, WhatIsGoneIsWaitedFor) {
    const std::string part =
        "format = 1\n[[body]]\nname = \"b\"\nshape = { sphere = 0.2 }\nat = [2, 1, 0]\n";
    fs::create_directory(folder / "parts");
    write(folder / "parts/part.toml", part);
    write(folder / "my.toml", "include = [\"parts/part.toml\"]\n" + kFall);
    Conversation watching(launch({"-o", "made"}));
    watching.until("watching my.toml and the file that it reads");
    fs::remove_all(folder / "parts");
    EXPECT_NE(watching.until("parts/part.toml").find("impulse: my.toml:1:"), std::string::npos);
    fs::create_directory(folder / "parts");
    write(folder / "parts/part.toml", part);
    watching.until("no frame changed");
    fs::rename(folder / "my.toml", folder / "away");
    EXPECT_NE(watching.until("gone").find("impulse: my.toml is gone; waiting for it\n"),
              std::string::npos);
    fs::rename(folder / "away", folder / "my.toml");
    EXPECT_EQ(watching.until("\n"), "no frame changed\n");
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

TEST_F(Watch, ADraftThatWasRemovedComesBack) {
    Conversation watching(launch({}));
    watching.until("watching my.toml");
    fs::remove_all(folder / "output");
    replace("my.toml", kFall);
    watching.until("open it");
    EXPECT_TRUE(fs::exists(made("draft.png")));
    EXPECT_EQ(watching.endBy(SIGINT), 130);
}

TEST_F(Watch, OneWatcherAFolder) {
    Conversation watching(launch({}));
    watching.until("watching my.toml");
    const Ended second = run(launch({"--once"}));
    EXPECT_EQ(second.code, 5) << second.err;
    EXPECT_NE(second.err.find("drafts in 'output/my' are being written by another watch"),
              std::string::npos)
        << second.err;
    const Ended frames = run(
        folder.path(), {"render", "my.toml", "--size", "96x54", "--fps", "10", "--seconds", "0.1"});
    EXPECT_EQ(frames.code, 0) << frames.err;
    EXPECT_EQ(watching.endBy(SIGINT), 130);
    EXPECT_EQ(run(launch({"--once"})).code, 0);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "output/my"))
        EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
}

TEST_F(Watch, OptionsOfAPictureWork) {
    const Ended ended = run(launch({"--once", "--json", "--seconds", "1", "--set", "world.hz=30",
                                    "--show", "axes", "--theme", "dark", "-o", "here"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(draftIn(ended.out)["frames"], 15);
    EXPECT_TRUE(fs::exists(folder / "here/draft.png"));
}

TEST_F(Watch, SaysWhatIsWrong) {
    const auto ended = [&](std::vector<std::string> arguments) {
        return run(folder.path(), std::move(arguments));
    };
    EXPECT_EQ(ended({"watch", "stack"}).code, 2);
    EXPECT_NE(ended({"watch", "stack"}).err.find("give --once"), std::string::npos);
    EXPECT_EQ(ended({"watch", "none.toml"}).code, 3);
    EXPECT_EQ(ended({"watch", "gone/none.toml"}).errorLines(), 1);
    EXPECT_EQ(ended({"watch", "stakc"}).code, 3);
    const Ended clear = ended({"watch", "my.toml", "--theme", "transparent"});
    EXPECT_EQ(clear.code, 2);
    EXPECT_NE(clear.err.find("a draft has no alpha"), std::string::npos) << clear.err;
}

TEST_F(Watch, ADraftWithAnIncidentIsWhole) {
    write(folder / "my.toml", kFastBall);
    const Ended ended = run(launch({"--once", "--json"}));
    EXPECT_EQ(ended.code, 6) << ended.err;
    EXPECT_EQ(draftIn(ended.out).at("frames"), 15);
    EXPECT_NE(ended.err.find("my: step 1 (t = 0.017 s): body 'ball': faster"), std::string::npos)
        << ended.err;
}

}  // namespace
}  // namespace demos::test
