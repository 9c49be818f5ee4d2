// impulse approve: what it takes from a folder of results, and where it writes.
#include "tests/demos/commands/ball_snapshots.h"

namespace demos::test {
namespace {

class Approvals : public Snapshots {};

TEST_F(Approvals, TakeWhatWasSeen) {
    ASSERT_EQ(test().code, 0);
    change("at = [0.1, 2, 0]", "at = [0.2, 2, 0]");
    ASSERT_EQ(test().code, 1);
    const std::string shown = contentOf(folder / "output/test/ball.snapshots/t0.5.png");
    const std::string before = baseline("t0.png");
    ASSERT_EQ(impulse({"approve", "ball@0.5"}).code, 0);
    EXPECT_EQ(baseline("t0.5.png"), shown);
    EXPECT_EQ(baseline("t0.png"), before);
    EXPECT_EQ(test().code, 1);  // one picture and the physics are not accepted yet
    EXPECT_EQ(scene().at("pictures").at(1).at("kind"), "same");
    ASSERT_EQ(impulse({"approve", "ball@physics"}).code, 0);
    EXPECT_EQ(test().code, 1);
    EXPECT_EQ(scene().at("physics").at("kind"), "same");
    const Ended all = impulse({"approve", "--all"});
    EXPECT_EQ(all.code, 0) << all.err;
    EXPECT_NE(all.out.find("next: impulse test, as the last time"), std::string::npos) << all.out;
    EXPECT_EQ(test().code, 0);
}

TEST_F(Approvals, RefuseWhatWasChangedAfterTheTest) {
    ASSERT_EQ(test().code, 0);
    change("at = [0.1, 2, 0]", "at = [0.2, 2, 0]");
    ASSERT_EQ(test().code, 1);
    write(folder / "output/test/ball.snapshots/t0.png", "no picture");
    const std::string before = baseline("baseline.json");
    const Ended ended = impulse({"approve", "ball"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_EQ(baseline("baseline.json"), before);
}

TEST_F(Approvals, TakeAChangeThatMovesNothing) {
    ASSERT_EQ(test().code, 0);
    change("[[body]]", "[[material]]\nname = \"unused\"\n[[body]]");
    for (int times = 0; times < 2; ++times) {  // named each time, not only before it is in the cache
        const Ended named = test();
        EXPECT_EQ(named.code, 0) << named.err;
        EXPECT_NE(named.out.find("changed, but no motion, force or picture"), std::string::npos) << named.out;
    }
    ASSERT_EQ(impulse({"approve", "ball"}).code, 0);
    EXPECT_EQ(test().out.find("changed, but"), std::string::npos);
}

TEST_F(Approvals, BelongToASceneThatStillHasItsTimes) {
    ASSERT_EQ(test().code, 0);
    change("times = [0.0, 0.5]", "times = []");
    const Ended ended = test();
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("the scene lists no [snapshot] times"), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find("to accept it"), std::string::npos) << ended.err;
}

TEST_F(Approvals, PruneOrphans) {
    ASSERT_EQ(impulse({"test", "."}).code, 0);
    change("times = [0.0, 0.5]", "times = [0.0]");
    fs::copy(folder / "ball.snapshots", folder / "old.snapshots");
    write(folder / "old.snapshots/notes.txt", "mine");
    const Ended ended = impulse({"test", "."});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("t0.5.png belongs to a time that the scene does not list"),
              std::string::npos)
        << ended.out;
    EXPECT_NE(ended.out.find("old.snapshots belongs to no scene"), std::string::npos) << ended.out;
    ASSERT_EQ(impulse({"approve", "--prune"}).code, 0);
    EXPECT_FALSE(has("ball.snapshots/t0.5.png"));
    EXPECT_TRUE(has("ball.snapshots/t0.png"));
    EXPECT_FALSE(has("old.snapshots/baseline.json"));
    EXPECT_TRUE(has("old.snapshots/notes.txt"));
}

/// Two folders of scenes keep their baselines in one place, and are tested one after the other.
TEST_F(Approvals, PruneNoBaselineWhoseSceneIsInAnotherFolder) {
    for (const char* file : {"a/ball.toml", "b/box.toml", "b/gone.toml"}) {
        fs::create_directories((folder / file).parent_path());
        write(folder / file, kBallOnABox);
    }
    const auto testOf = [&](const char* scenes) {
        return impulse({"test", scenes, "--baselines", "kept"});
    };
    ASSERT_EQ(testOf("a").code, 0);
    ASSERT_EQ(testOf("b").code, 0);
    EXPECT_EQ(testOf("a").out.find("belongs to no scene"), std::string::npos);
    ASSERT_EQ(impulse({"approve", "--prune", "--baselines", "kept"}).code, 0);
    EXPECT_TRUE(has("kept/box.snapshots/baseline.json"));
    fs::remove(folder / "b/gone.toml");
    const std::string said = testOf("a").out;
    EXPECT_NE(said.find("gone.snapshots belongs to no scene"), std::string::npos) << said;
    ASSERT_EQ(impulse({"approve", "--prune", "--baselines", "kept"}).code, 0);
    EXPECT_FALSE(has("kept/gone.snapshots"));
    EXPECT_TRUE(has("kept/box.snapshots/baseline.json"));
    EXPECT_TRUE(has("kept/ball.snapshots/baseline.json"));
    fs::rename(folder / "b", folder / "c");  // as where baselines were moved: nothing is known of their scenes
    EXPECT_EQ(testOf("a").out.find("belongs to no scene"), std::string::npos);
}

class EditedReport : public Snapshots {
protected:
    EditedReport() {
        test();
        good_ = contentOf(folder / "output/test/report.json");
        for (const fs::path& kept : {folder / "other.snapshots", outside.path() / "ball.snapshots"})
            fs::copy(folder / "ball.snapshots", kept);
        write(outside / "ball.toml", kBallOnABox);
    }

    /// Writes the report with every `from` replaced.
    void edit(const std::vector<std::pair<std::string, std::string>>& changes) {
        std::string text = good_;
        for (const auto& [from, to] : changes) {
            const std::size_t at = text.find(from);
            ASSERT_NE(at, std::string::npos) << from << "\n" << good_;
            text.replace(at, from.size(), to);
        }
        write(folder / "output/test/report.json", text);
    }

    /// Nothing is accepted or removed, and one line tells why.
    void expectRefused(const std::string& why) {
        for (const char* what : {"--prune", "--all", "ball"}) {
            const Ended ended = impulse({"approve", what});
            EXPECT_EQ(ended.code, 4) << what << ended.out;
            EXPECT_EQ(ended.errorLines(), 1) << ended.err;
            EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
        }
        for (const fs::path& kept : {folder / "other.snapshots", outside.path() / "ball.snapshots",
                                     folder / "ball.snapshots"})
            for (const char* file : {"baseline.json", "t0.png", "t0.5.png"})
                EXPECT_TRUE(fs::exists(kept / file)) << kept << file;
    }

    std::string good_;
    TemporaryFolder outside;
};

TEST_F(EditedReport, NamesNoFolderOutsideThisOne) {
    const std::string there = (outside / "ball").string();
    edit({{"\"folder\": \"ball.snapshots\"", "\"folder\": \"" + there + ".snapshots\""},
          {"\"orphans\": []\n", "\"orphans\": [\"t0.png\", \"t0.5.png\"]\n"}});
    expectRefused("not next to the scene; run impulse test again, or name the folder");
    edit({{"\"scene\": \"ball.toml\"", "\"scene\": \"" + there + ".toml\""},
          {"\"folder\": \"ball.snapshots\"", "\"folder\": \"" + there + ".snapshots\""}});
    expectRefused("which is not a scene file in this folder");
    fs::create_directory_symlink(outside.path(), folder / "link");
    edit({{"\"scene\": \"ball.toml\"", "\"scene\": \"link/ball.toml\""},
          {"\"folder\": \"ball.snapshots\"", "\"folder\": \"link/ball.snapshots\""}});
    expectRefused("which is not a scene file in this folder");
    edit({{"\"name\": \"ball\"", "\"name\": \"../ball\""}});
    expectRefused("has a scene called '../ball'");
}

TEST_F(EditedReport, RemovesOnlyWhatHasNoScene) {
    const auto orphan = [&](const std::string& name) {
        edit({{"\"orphans\": []", "\"orphans\": [\"" + name + "\"]"}});
    };
    for (const std::string& name :
         {std::string("ball.snapshots"), (outside / "ball.snapshots").string(),
          "../" + outside.path().filename().string() + "/ball.snapshots", std::string("keep.me"),
          std::string("other.snapshots/../ball.snapshots")}) {
        orphan(name);
        expectRefused("a baseline without a scene, which it is not");
    }
    write(folder / "other.toml", kBallOnABox);
    orphan("other.snapshots");
    expectRefused("a baseline without a scene, which it is not");
    fs::remove(folder / "other.toml");
    EXPECT_EQ(impulse({"approve", "--prune"}).code, 0);
    EXPECT_FALSE(has("other.snapshots"));
}

TEST_F(EditedReport, RemovesNoPictureOfATimeThatTheSceneLists) {
    edit({{"\"orphans\": []\n", "\"orphans\": [\"t0.png\", \"t0.5.png\"]\n"}});
    EXPECT_EQ(impulse({"approve", "--prune"}).code, 0);
    for (const char* file : {"t0.png", "t0.5.png"}) EXPECT_TRUE(fs::exists(folder / "ball.snapshots" / file));
    edit({{"\"scene\": \"ball.toml\"", "\"scene\": \"ball.toml\\u0000/../ball.toml\""}});
    expectRefused("has a path with a zero byte");
    write(folder / "never.toml", kBallOnABox);
    edit({{"\"scene\": \"ball.toml\"", "\"scene\": \"never.toml\""}});
    expectRefused("which is another scene");
}

TEST_F(EditedReport, RunsNothing) {
    edit({{"\"command\": \"impulse test", "\"command\": \"impulse test -o ~/.ssh"}});
    const Ended ended = impulse({"approve", "--prune"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.out.find(".ssh"), std::string::npos) << ended.out;
}

TEST_F(Approvals, WriteWhereTheCommandLineSays) {
    ASSERT_EQ(test({"--baselines", "kept"}).code, 0);
    change("at = [0.1, 2, 0]", "at = [0.2, 2, 0]");
    ASSERT_EQ(test({"--baselines", "kept"}).code, 1);
    const Ended ended = impulse({"approve", "ball"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_NE(ended.err.find("with --baselines"), std::string::npos) << ended.err;
    ASSERT_EQ(impulse({"approve", "ball", "--baselines", "kept"}).code, 0);
    EXPECT_EQ(test({"--baselines", "kept"}).code, 0);
    EXPECT_FALSE(has("ball.snapshots"));
}

/// A downloaded folder of results may hold links.
TEST_F(Approvals, ReadThroughNoLinkedFolder) {
    ASSERT_EQ(test().code, 0);
    change("at = [0.1, 2, 0]", "at = [0.2, 2, 0]");
    ASSERT_EQ(test().code, 1);
    fs::rename(folder / "output/test/ball.snapshots", folder / "elsewhere");
    fs::create_directory_symlink(folder / "elsewhere", folder / "output/test/ball.snapshots");
    const Ended ended = impulse({"approve", "ball"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_NE(ended.err.find("is a symbolic link"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace demos::test
