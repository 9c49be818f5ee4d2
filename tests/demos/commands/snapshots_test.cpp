// impulse test, run as by a user.
#include <regex>
#include <sstream>

#include "tests/demos/commands/ball_snapshots.h"

namespace demos::test {
namespace {

TEST_F(Snapshots, AreMadeTheFirstTimeAndKeptTheSecond) {
    const Ended first = test();
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_NE(first.out.find("new      ball  2 pictures, 1 expectation"), std::string::npos)
        << first.out;
    for (const char* file : {"baseline.json", "t0.png", "t0.5.png"})
        EXPECT_TRUE(has(std::string("ball.snapshots/") + file)) << file;
    const Ended second = test();
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_NE(second.out.find("ok       ball  2 pictures, 1 expectation\n"), std::string::npos)
        << second.out;
    EXPECT_FALSE(has("output/test/ball.snapshots"));
}

TEST_F(Snapshots, AreNotMadeInCi) {
    const Ended ended = impulse({"test", "ball.toml"}, true);
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("there is no baseline, and --update is none"), std::string::npos)
        << ended.err;
    EXPECT_FALSE(has("ball.snapshots"));
    EXPECT_EQ(impulse({"test", "ball.toml", "--update", "missing"}, true).code, 0);
    EXPECT_EQ(impulse({"test", "ball.toml"}, true).code, 0);
}

TEST_F(Snapshots, TellPhysicsFromRendering) {
    ASSERT_EQ(test().code, 0);
    change("from = [3, 2.5, 6]", "from = [3, 2.6, 6]");
    EXPECT_EQ(test().code, 1);
    EXPECT_EQ(scene().at("physics").at("kind"), "same");
    EXPECT_EQ(scene().at("pictures").at(0).at("kind"), "changed");

    write(folder / "ball.toml", kBallOnABox);
    change("at = [0.1, 2, 0]", "at = [0.1, 2.001, 0]");
    const Ended moved = test();
    EXPECT_EQ(moved.code, 1);
    const Json physics = scene().at("physics");
    EXPECT_EQ(physics.at("kind"), "changed");
    EXPECT_EQ(physics.at("step"), 0);
    EXPECT_EQ(physics.at("body"), "ball");
    EXPECT_EQ(physics.at("field"), "y");
    EXPECT_NEAR(physics.at("difference").get<double>(), 0.001, 2e-5);
    EXPECT_NE(moved.err.find("step 0 (0 s): ball y differs by 1 mm"), std::string::npos)
        << moved.err;
    EXPECT_NE(moved.err.find("to accept it: impulse approve ball"), std::string::npos);
}

/// A body far behind the camera, moved by a metre: no picture shows it.
TEST_F(Snapshots, ReportPhysicsThatNoPictureShows) {
    change("[camera]", "[[body]]\nname = 'far'\nshape = { sphere = 0.5 }\nat = [0, 0.5, 90]\n[camera]");
    ASSERT_EQ(test().code, 0);
    change("at = [0, 0.5, 90]", "at = [0, 0.5, 91]");
    const Ended ended = test();
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(scene().at("pictures").at(0).at("kind"), "changed");
    EXPECT_NE(scene().at("pictures").at(1).at("kind"), "changed");
    EXPECT_EQ(scene().at("physics").at("body"), "far");
}

/// The loads tell a mass that neither poses nor pictures show.
TEST_F(Snapshots, ReportForcesThatNoPoseShows) {
    change("at = [0.1, 2, 0]", "at = [5, 0.5, 0]\ndensity = 500");
    ASSERT_EQ(test().code, 0);
    change("density = 500", "density = 750");
    const Ended ended = test();
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(scene().at("physics").at("field"), "load");
    EXPECT_NE(ended.err.find("the load of ball differs: 2566 -> 3852 N"), std::string::npos)
        << ended.err;
    EXPECT_NE(ended.err.find("made with other settings: body.ball.density 500 -> 750"),
              std::string::npos)
        << ended.err;
}

TEST_F(Snapshots, NameWhatWasEditedAndDoesNotMatter) {
    change("at = [0.1, 2, 0]", "at = [5, 0.5, 0]\ndensity = 500");
    ASSERT_EQ(test().code, 0);
    change("density = 500", "density = 510  # light");
    change("below = 0.05", "below = 0.06");
    const Ended ended = test();
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("changed, but no motion, force or picture beyond the tolerances: "
                             "body.ball.density 500 -> 510, expect.penetration of all.below "
                             "0.05 -> 0.06"),
              std::string::npos)
        << ended.out;
    ASSERT_EQ(test({"--update", "all"}).code, 0);
    EXPECT_EQ(test({"--no-cache"}).out.find("changed"), std::string::npos);
    change("# light", "# heavy");
    EXPECT_EQ(test().out.find("changed"), std::string::npos);
}

TEST_F(Snapshots, AreDrawnWithoutDithering) {
    ASSERT_EQ(test().code, 0);
    const std::string before = baseline("t0.png");
    ASSERT_FALSE(before.empty());
    change("[camera]", "[look]\ndither = true\n[camera]");
    ASSERT_EQ(test({"--update", "all"}).code, 0);
    EXPECT_EQ(baseline("t0.png"), before);
}

TEST_F(Snapshots, LetAHarmlessChangeOfBitsPass) {
    ASSERT_EQ(test().code, 0);
    change("at = [0.1, 2, 0]", "at = [0.1, 2.00000001, 0]");
    const Ended ended = test();
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(scene().at("physics").at("kind"), "bits");
    EXPECT_NE(ended.out.find("the bits differ from step 0 on"), std::string::npos) << ended.out;
}

TEST_F(Snapshots, TakeTheSceneTolerances) {
    ASSERT_EQ(test().code, 0);
    change("at = [0.1, 2, 0]", "at = [0.1, 2.001, 0]");
    change("size = [160, 90]",
           "size = [160, 90]\ntolerance = { position = 0.1, angle_deg = 5, why = 'coarse' }\n"
           "gate = { levels = 60, window = 200, ssim = 0.2, why = 'coarse' }");
    const Ended ended = test();
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(scene().at("snapshot").at("tolerance").at("why"), "coarse");
}

TEST_F(Snapshots, CheckTheContract) {
    change("below = 0.05", "below = 1e-9");
    const Ended ended = test();
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("expectation failed: deepest penetration"), std::string::npos) << ended.err;
    EXPECT_FALSE(has("ball.snapshots"));  // no baseline of a broken contract
    EXPECT_EQ(test({"--update", "all"}).code, 1);
    EXPECT_FALSE(has("ball.snapshots"));
    const Ended approved = impulse({"approve", "ball"});
    EXPECT_EQ(approved.code, 1);
    EXPECT_NE(approved.err.find("which no baseline can fix"), std::string::npos) << approved.err;
}

TEST_F(Snapshots, AreUpdatedAsAskedFor) {
    ASSERT_EQ(test().code, 0);
    change("at = [0.1, 2, 0]", "at = [0.2, 2, 0]");
    EXPECT_EQ(test({"--update", "missing"}).code, 1);
    EXPECT_EQ(test({"--update", "none"}).code, 1);
    const Ended changed = test({"--update", "changed"});
    EXPECT_EQ(changed.code, 0) << changed.err;
    EXPECT_NE(changed.out.find("updated  ball"), std::string::npos) << changed.out;
    EXPECT_EQ(test().code, 0);
    change("times = [0.0, 0.5]", "times = [0.0, 0.5, 1.0]");
    EXPECT_EQ(test({"--update", "none"}).code, 1);
    const std::string before = baseline("t0.png");
    EXPECT_EQ(test({"--update", "missing"}).code, 0);
    EXPECT_TRUE(has("ball.snapshots/t1.png"));
    EXPECT_EQ(baseline("t0.png"), before);
    EXPECT_EQ(test({"--update", "none"}).code, 0);
}

TEST_F(Snapshots, LeaveOutWhatHasNotChanged) {
    ASSERT_EQ(test().code, 0);
    ASSERT_EQ(test().code, 0);
    EXPECT_NE(test().out.find("ball  (as before)"), std::string::npos);
    EXPECT_EQ(test({"--no-cache"}).out.find("(as before)"), std::string::npos);
    fs::resize_file(folder / "ball.snapshots/t0.png", 100);
    EXPECT_EQ(test().code, 1);  // the cache must not hide this
}

TEST_F(Snapshots, NothingIsWrittenThroughALinkedFolder) {
    fs::create_directory(folder / "elsewhere");
    fs::create_directory_symlink("elsewhere", folder / "ball.snapshots");
    const Ended ended = test();
    EXPECT_NE(ended.code, 0);
    EXPECT_NE((ended.out + ended.err).find("is a symbolic link"), std::string::npos)
        << ended.out << ended.err;
    EXPECT_TRUE(fs::is_empty(folder / "elsewhere"));
}

TEST_F(Snapshots, OfOneSceneDoNotFailTheOthers) {
    write(folder / "good.toml", kBallOnABox);
    write(folder / "part.toml", "[[body]]\nname = 'a'\nshape = { sphere = 1 }\n");
    ASSERT_EQ(impulse({"test", "."}).code, 0);
    change("format = 1", "format = 1\nspeed = 3");
    const Ended ended = impulse({"test", "."});
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("ERROR    ball"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("ball.toml:2:1: "), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("part.toml: has no 'format = 1'"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("2 scenes: 1 passed, 1 error"), std::string::npos) << ended.out;
}

TEST_F(Snapshots, SayWhatIsWrongWithABaseline) {
    ASSERT_EQ(test().code, 0);
    const std::string json = baseline("baseline.json"), png = baseline("t0.png");
    const auto tells = [&](const char* what) {
        const Ended ended = test();
        EXPECT_EQ(ended.code, 1);
        EXPECT_NE(ended.err.find(what), std::string::npos) << what << "\n" << ended.err;
    };
    write(folder / "ball.snapshots/t0.png", png.substr(0, 200));
    tells("t0.png does not match baseline.json next to it");
    write(folder / "ball.snapshots/t0.png", "version https://git-lfs.github.com/spec/v1\noid");
    tells("t0.png is a pointer of Git LFS; fetch the file with git lfs pull");
    write(folder / "ball.snapshots/t0.png", png);
    write(folder / "ball.snapshots/baseline.json", json.substr(0, 300));
    tells("baseline.json is damaged");
    write(folder / "ball.snapshots/baseline.json",
          std::regex_replace(json, std::regex("\"format\": 2"), "\"format\": 7"));
    tells("baseline.json has format 7, but this impulse reads 2; use a newer impulse");
    write(folder / "ball.snapshots/baseline.json",
          std::regex_replace(json, std::regex("\"seconds\": \"1\""), "\"seconds\": \"2\""));
    tells("baseline.json was edited");
    write(folder / "ball.snapshots/baseline.json", json);
    change("seconds = 1.0", "seconds = 1.0\nworld = { hz = 120 }");
    tells("60 steps a second, the scene has 120");
    change("hz = 120", "hz = 60");
    change("size = [160, 90]", "size = [160, 100]");
    tells("the baseline's pictures are 160x90, those of the scene 160x100");
}

TEST_F(Snapshots, RefuseToWriteOverBaselines) {
    ASSERT_EQ(test().code, 0);
    const Ended ended = test({"-o", "."});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("is where the baselines are"), std::string::npos) << ended.err;
    EXPECT_TRUE(has("ball.snapshots/t0.png"));
}

TEST_F(Snapshots, GoOnAfterAnInterruption) {
    for (const char* name : {"a.toml", "b.toml", "c.toml"}) write(folder / name, kBallOnABox);
    ASSERT_EQ(impulse({"test", "."}).code, 0);
    ASSERT_EQ(impulse({"test", ".", "--no-cache"}).code, 0);
    fs::remove(folder / "output/test/passed.json");
    Launch launch;
    launch.folder = folder.path();
    launch.arguments = {"test", ".", "-j", "1"};
    launch.awaited = "ok       a";
    launch.signal = SIGINT;
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 130);
    EXPECT_NE(ended.err.find("; to resume: impulse test . -j 1"), std::string::npos) << ended.err;
    EXPECT_NE(impulse({"test", "."}).out.find("a  (as before)"), std::string::npos);
}

// Failures are reported on standard error, scene by scene; the report comes last.
TEST_F(Snapshots, AreReportedWhoeverHasStoppedReading) {
    ASSERT_EQ(test().code, 0);
    change("at = [0.1, 2, 0]", "at = [0.2, 2, 0]");
    for (const int stream : {STDERR_FILENO, STDOUT_FILENO}) {
        fs::remove(folder / "output/test/report.json");
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = {"test", "ball.toml"};
        launch.beforeExec = withoutReader(stream);
        EXPECT_EQ(run(launch).code, stream == STDERR_FILENO ? 1 : 4);
        const Json report = Json::parse(contentOf(folder / "output/test/report.json"));
        EXPECT_EQ(report["passed"], false);
    }
}

TEST_F(Snapshots, SpeakJson) {
    const Ended ended = test({"--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    std::vector<Json> events;
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);) events.push_back(Json::parse(line));
    ASSERT_EQ(events.size(), 3u);
    EXPECT_EQ(events[1].at("event"), "scene");
    EXPECT_EQ(events[1].at("name"), "ball");
    EXPECT_EQ(events[2].at("passed"), true);
}

TEST_F(Snapshots, RefuseWhatCannotBeMeant) {
    const auto refused = [&](std::vector<std::string> arguments, int code, const char* what) {
        const Ended ended = impulse(std::move(arguments));
        EXPECT_EQ(ended.code, code) << what;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find(what), std::string::npos) << ended.err;
    };
    fs::create_directories(folder / "empty");
    fs::create_directories(folder / "other");
    write(folder / "other/ball.toml", kBallOnABox);
    refused({"test", "bal"}, 3, "no built-in scene and no file 'bal'");
    refused({"test", "empty"}, 2, "holds no scene file");
    refused({"test", "ball.toml", "other/ball.toml"}, 2, "are both called 'ball'");
    refused({"test", "ball.toml", "--update", "every"}, 2, "known are: missing, changed");
    refused({"approve", "ball"}, 4, "run impulse test first");
    refused({"approve"}, 2, "approve what?");
    ASSERT_EQ(test().code, 0);
    refused({"approve", "ball"}, 2, "has nothing to accept");
    refused({"approve", "bal"}, 2, "did you mean 'ball'");
    change("at = [0.1, 2, 0]", "at = [0.2, 2, 0]");
    ASSERT_EQ(test().code, 1);
    refused({"approve", "ball@0.4"}, 2, "did you mean 'ball@0.5'");
    write(folder / "output/test/report.json", "{}");
    refused({"approve", "ball"}, 4, "is not a report of impulse test");
}

/// The dart is slowed down so little that no tolerance notices.
TEST_F(Snapshots, AnIncidentIsKeptAndANewOneFails) {
    change("[camera]",
           "[[body]]\nname = 'dart'\nshape = { sphere = 0.1 }\nmass = 1\nat = [0, 9, -50]\n"
           "velocity = [9999.5, 0, 0]\n[[force]]\ntype = 'constant'\non = ['dart']\n"
           "force = [0.12, 0, 0]\n[camera]");
    change("size = [160, 90]",
           "size = [160, 90]\ntolerance = { position = 1, angle_deg = 1, why = 'fast' }");
    ASSERT_EQ(test().code, 0);
    EXPECT_EQ(baseline("baseline.json").find("incidents"), std::string::npos);
    change("velocity = [9999.5, 0, 0]", "velocity = [9999.999, 0, 0]");
    const Ended added = test();
    EXPECT_EQ(added.code, 1);
    EXPECT_NE(added.err.find("a new incident: ball: step 1 (t = 0.017 s): body 'dart': faster"),
              std::string::npos)
        << added.err;
    EXPECT_EQ(scene().at("physics").at("kind"), "changed");
    ASSERT_EQ(impulse({"approve", "ball"}).code, 0);
    EXPECT_NE(baseline("baseline.json").find("\"trouble\": \"too fast\""), std::string::npos);
    const Ended kept = test();
    EXPECT_EQ(kept.code, 0) << kept.err;
    EXPECT_NE(kept.out.find("an incident, as in the baseline: ball: step 1 "), std::string::npos)
        << kept.out;
    change("velocity = [9999.999, 0, 0]", "velocity = [9999.5, 0, 0]");
    const Ended gone = test();
    EXPECT_EQ(gone.code, 0) << gone.err;
}

TEST_F(Snapshots, ANewBaselineTellsItsIncident) {
    change("at = [0.1, 2, 0]", "at = [0.1, 2, 0]\nspin = [0, 9999, 0]\n[[force]]\n"
                               "type = 'constant'\non = ['ball']\ntorque = [0, 1e6, 0]");
    const Ended first = test();
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_NE(first.out.find("a new incident: ball: step 1 "), std::string::npos) << first.out;
    EXPECT_EQ(test().code, 0);
    change("times = [0.0, 0.5]\n", "");
    const Ended unkept = test();
    EXPECT_EQ(unkept.code, 1);
    EXPECT_NE(unkept.err.find("only the baseline of a scene with [snapshot] times"),
              std::string::npos)
        << unkept.err;
}

}  // namespace
}  // namespace demos::test
