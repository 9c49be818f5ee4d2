#include <sys/file.h>
#include <sys/resource.h>

#include <regex>

#include "render/encode/png_read.h"
#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

class RenderCommand : public SmallFilm {};

TEST_F(RenderCommand, WritesFramesAndARecordAndSaysSo) {
    const Ended ended = film({});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Files frames = framesIn(folder / "output/ball");
    EXPECT_EQ(frames.size(), static_cast<std::size_t>(kFrames));
    EXPECT_TRUE(frames.contains("frame_000009.png"));
    for (const auto& [name, png] : frames) EXPECT_TRUE(isWhole(png)) << name;
    EXPECT_NE(contentOf(folder / "output/ball/run.json").find("\"finished\": true"),
              std::string::npos);
    EXPECT_NE(ended.out.find("wrote output/ball/frame_000000.png"), std::string::npos);
    EXPECT_NE(ended.out.find("next: "), std::string::npos);
    EXPECT_NE(ended.err.find("100 %"), std::string::npos);
}

TEST_F(RenderCommand, TheRecordSaysWhatTheFilmIsMadeOf) {
    const bool ffmpeg = haveTools();
    std::vector<std::string> arguments = {"--seconds", "0.2",      "-o",
                                          "out",       "--set",    "world.hz=120",
                                          "--show",    "contacts", "--reproducible"};
    if (ffmpeg) arguments.insert(arguments.end(), {"-o", "film.mp4"});
    ASSERT_EQ(film(arguments).code, 0);
    const std::string record = contentOf(folder / "out/run.json");
    for (const char* part :
         {"\"impulse\": \"", "\"command\": \"impulse render ball.toml", "\"renderer\": \"llvmpipe",
          "Mesa ", "(LLVM ", "\"pixels\": \"reproducible\"", "\"theme\": \"studio\"",
          "\"contacts\"", "\"world.hz=120\"", "\"samples\": 1", "\"fps\": 10", "\"hz\": 120",
          "\"state\": \"", "\"png\": \""})
        EXPECT_NE(record.find(part), std::string::npos) << part << " in\n" << record;
    EXPECT_EQ(record.find("\"ffmpeg\": \"") != std::string::npos, ffmpeg) << record;
}

TEST_F(RenderCommand, TheNumberOfJobsDoesNotChangeAFrame) {
    ASSERT_EQ(film({"-o", "one", "--jobs", "1"}).code, 0);
    ASSERT_EQ(film({"-o", "two", "--jobs", "2"}).code, 0);
    EXPECT_EQ(framesIn(folder / "one"), framesIn(folder / "two"));
    EXPECT_EQ(framesIn(folder / "one").size(), static_cast<std::size_t>(kFrames));
}

// One process worked alone and simulated; three get states from a fourth.
TEST_F(RenderCommand, TheNumberOfJobsDoesNotChangeWhatAFrameRemembers) {
    const auto framesOf = [this](const std::string& jobs, std::vector<std::string> more) {
        more.insert(more.end(), {"-o", jobs + more.front(), "--jobs", jobs, "--show",
                                 "trails,ghost,stats,nudges,impulses"});
        EXPECT_EQ(film(more).code, 0);
        return framesIn(folder / more[more.size() - 5]);
    };
    for (const std::vector<std::string>& film :
         {std::vector<std::string>{"--blur", "3"}, {"--frames", "0..4:2,3"}, {"--pass", "flow"}}) {
        const Files alone = framesOf("1", film);
        EXPECT_FALSE(alone.empty());
        EXPECT_EQ(framesOf("3", film), alone) << film.front();
    }
}

TEST_F(RenderCommand, QuietSaysNothing) {
    const Ended ended = film({"--quiet", "--seconds", "0.2"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_TRUE(ended.out.empty()) << ended.out;
    EXPECT_TRUE(ended.err.empty()) << ended.err;
}

TEST_F(RenderCommand, ASecondRunKeepsEveryFrame) {
    ASSERT_EQ(film({"--seconds", "0.3"}).code, 0);
    const fs::path frame = folder / "output/ball/frame_000001.png";
    const auto written = fs::last_write_time(frame);
    const Ended again = film({"--seconds", "0.3"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("3 kept"), std::string::npos) << again.out;
    EXPECT_EQ(fs::last_write_time(frame), written);
}

TEST_F(RenderCommand, ATornOrChangedFrameIsDrawnAgain) {
    ASSERT_EQ(film({"--seconds", "0.3"}).code, 0);
    const Files before = framesIn(folder / "output/ball");
    write(folder / "output/ball/frame_000000.png", before.at("frame_000000.png").substr(0, 99));
    write(folder / "output/ball/frame_000002.png", before.at("frame_000001.png"));
    const Ended again = film({"--seconds", "0.3"});
    EXPECT_NE(again.out.find("1 kept"), std::string::npos) << again.out;
    EXPECT_EQ(framesIn(folder / "output/ball"), before);
}

TEST_F(RenderCommand, OtherSettingsAreRefusedUntilOverwriteIsSaid) {
    ASSERT_EQ(film({}).code, 0);
    const Files before = framesIn(folder / "output/ball");
    const Ended refused = film({"--seconds", "0.5"});
    EXPECT_EQ(refused.code, 5);
    EXPECT_EQ(refused.errorLines(), 1);
    EXPECT_NE(refused.err.find("--overwrite"), std::string::npos) << refused.err;
    EXPECT_EQ(framesIn(folder / "output/ball"), before);
    EXPECT_EQ(film({"--seconds", "0.5", "--overwrite"}).code, 0);
    EXPECT_EQ(framesIn(folder / "output/ball").size(), 5u);  // no frame of the longer film is left
}

TEST_F(RenderCommand, FramesOfUnknownOriginAreRefused) {
    fs::create_directories(folder / "mine");
    write(folder / "mine/frame_000003.png", "precious");
    EXPECT_EQ(film({"-o", "mine"}).code, 5);
    EXPECT_EQ(contentOf(folder / "mine/frame_000003.png"), "precious");
}

TEST_F(RenderCommand, ResumingAKilledRunGivesTheFilesOfAnUndisturbedOne) {
    write(folder / "ball.toml", kBall);
    ASSERT_EQ(film({"-o", "calm", "--seconds", "20"}).code, 0);
    Launch killed = small(folder.path(), {"-o", "torn", "--seconds", "20", "--json"});
    // The record is written after every fifty frames; some more are drawn until the signal arrives.
    killed.awaited = "\"frame\":55,";
    killed.signal = SIGKILL;
    EXPECT_EQ(run(killed).signal, SIGKILL);
    EXPECT_LT(framesIn(folder / "torn").size(), 200u);
    write(folder / "torn/frame_000060.png.tmp4711", "half a frame");
    const Ended resumed = film({"-o", "torn", "--seconds", "20"});
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_TRUE(std::regex_search(resumed.out, std::regex(" (50|100|150) kept"))) << resumed.out;
    EXPECT_EQ(framesIn(folder / "torn"), framesIn(folder / "calm"));
    EXPECT_FALSE(fs::exists(folder / "torn/frame_000060.png.tmp4711"));
}

// The first is the process that simulates, the others draw.
TEST_F(RenderCommand, ADeadChildIsCode4AndNoHang) {
    for (const int number : {0, 1, 2}) {
        Launch launch = small(folder.path(), {"--seconds", "20", "--json", "--jobs", "2"});
        launch.awaited = "\"frame\":4,";
        bool found = false;
        launch.awaitedCall = [&](pid_t parent) {
            const std::string name = std::to_string(parent);
            std::ifstream children("/proc/" + name + "/task/" + name + "/children");
            pid_t child = 0;
            for (int i = 0; i <= number; ++i) found = static_cast<bool>(children >> child);
            kill(found ? child : parent, SIGKILL);
        };
        const Ended ended = run(launch);
        if (!found) GTEST_SKIP() << "this kernel does not name a process's children";
        EXPECT_EQ(ended.code, 4);
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find(number == 0 ? "simulating process was killed by signal 9"
                                             : "drawing process was killed by signal 9"),
                  std::string::npos)
            << ended.err;
    }
}

TEST_F(RenderCommand, AFolderIsWrittenByOneRunAtATime) {
    fs::create_directories(folder / "out");
    const int other = open((folder / "out").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ASSERT_EQ(flock(other, LOCK_EX), 0);
    const Ended ended = film({"-o", "out"});
    close(other);
    EXPECT_EQ(ended.code, 5);
    EXPECT_NE(ended.err.find("another run"), std::string::npos) << ended.err;
    EXPECT_TRUE(fs::is_empty(folder / "out"));
}

TEST_F(RenderCommand, AnInterruptFinishesTheFrameAndNamesTheCommandToGoOn) {
    Launch launch = small(folder.path(), {"--seconds", "20", "--json"});
    launch.awaited = "\"frame\":4,";
    launch.signal = SIGINT;
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 130);
    EXPECT_EQ(ended.errorLines(), 1);
    EXPECT_NE(ended.err.find("to resume: impulse render ball.toml"), std::string::npos)
        << ended.err;
    for (const auto& [name, png] : framesIn(folder / "output/ball"))
        EXPECT_TRUE(isWhole(png)) << name;
    const Ended resumed = film({"--seconds", "20"});
    EXPECT_EQ(resumed.code, 0);
    EXPECT_NE(resumed.out.find(" kept"), std::string::npos) << resumed.out;
}

TEST_F(RenderCommand, AnInterruptedFilmIsNotThereAndTheSameCommandMakesIt) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Launch launch = small(folder.path(), {"--seconds", "20", "--json", "-o", "film.mp4"});
        launch.awaited = "\"frame\":4,";
        launch.signal = signal;
        const Ended ended = run(launch);
        EXPECT_EQ(ended.code, 130);
        EXPECT_NE(ended.err.find("no film was written"), std::string::npos) << ended.err;
        EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"ball.toml"});
    }
    EXPECT_EQ(film({"-o", "film.mp4"}).code, 0);
    EXPECT_EQ(playableFrames(folder / "film.mp4"), kFrames);
}

TEST_F(RenderCommand, ASceneThatIsCalledLikeAFolderIsRefused) {
    write(folder / "...toml", kBall);
    const Ended ended = run(folder.path(), {"render", "...toml", "--seconds", "0.1"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.err.find("rename it"), std::string::npos) << ended.err;
    EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{"...toml", "ball.toml"}));
}

TEST_F(RenderCommand, AFilmHasEveryFrameAndIsNotReplacedUnasked) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    const Ended ended = film({"-o", "film.mp4", "-o", "frames"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(playableFrames(folder / "film.mp4"), kFrames);
    EXPECT_EQ(framesIn(folder / "frames").size(), static_cast<std::size_t>(kFrames));
    EXPECT_EQ(film({"-o", "film.mp4"}).code, 5);
    EXPECT_EQ(film({"-o", "film.mp4", "--overwrite"}).code, 0);
}

TEST_F(RenderCommand, AFilmNeedsEvenSidesAndSaysSoAtOnce) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    const Ended ended =
        run(folder.path(), {"render", "ball.toml", "-o", "film.mp4", "--size", "97x55"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("even"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "film.mp4"));
}

TEST_F(RenderCommand, WithoutFfmpegAFilmIsCode4) {
    Launch launch = small(folder.path(), {"-o", "film.mp4"});
    launch.beforeExec = [] { setenv("PATH", "/nonexistent", 1); };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4);
    EXPECT_EQ(ended.errorLines(), 1);
    EXPECT_NE(ended.err.find("ffmpeg"), std::string::npos) << ended.err;
}

TEST_F(RenderCommand, AFullDiskIsCode4AndNoFrameIsTorn) {
    Launch launch = small(folder.path(), {"-o", "full", "--quiet"});
    ASSERT_EQ(film({"-o", "calm"}).code, 0);
    std::uintmax_t largest = 0;
    for (const auto& [name, png] : framesIn(folder / "calm"))
        largest = std::max<std::uintmax_t>(largest, png.size());
    launch.beforeExec = [largest] {  // the largest frame does not fit
        const rlimit limit{largest - 1, largest - 1};
        setrlimit(RLIMIT_FSIZE, &limit);
    };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4) << ended.err;
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    const Files frames = framesIn(folder / "full");
    EXPECT_LT(frames.size(), static_cast<std::size_t>(kFrames));
    for (const auto& [name, png] : frames) EXPECT_TRUE(isWhole(png)) << name;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "full"))
        EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
}

/// A body that is too fast is slowed down, and one that is too far away removed; the film goes on.
TEST_F(RenderCommand, AnIncidentIsCode6AndTheFilmIsWhole) {
    const std::string far = "[[body]]\nname = \"far\"\nshape = { sphere = 0.5 }\n"
                            "at = [99990, 5, 0]\nvelocity = [9000, 0, 0]\n";
    for (const std::string& scene : {kBall + "velocity = [0, 9950, 0]\n", kBall + far}) {
        write(folder / "ball.toml", scene);
        const Ended ended = film({"--set", "world.gravity=[0,100,0]", "--overwrite"});
        EXPECT_EQ(ended.code, 6) << ended.err;
        EXPECT_NE(ended.err.find(scene.ends_with(far) ? "body 'far': farther" : "body 'ball': faster"),
                  std::string::npos)
            << ended.err;
        EXPECT_EQ(framesIn(folder / "output/ball").size(), static_cast<std::size_t>(kFrames));
        const Ended again = film({"--set", "world.gravity=[0,100,0]"});
        EXPECT_NE(again.out.find("10 kept"), std::string::npos) << again.out;
        EXPECT_EQ(again.code, 6);
        EXPECT_EQ(again.err, ended.err.substr(ended.err.find("impulse: ")));
    }
    const Ended still = run(folder.path(), {"still", "ball.toml", "-o", "end.png"});
    EXPECT_EQ(still.code, 6) << still.err;
    EXPECT_TRUE(fs::exists(folder / "end.png"));
}

/// The last frame is drawn at 0.9 s; the ball is too fast from 0.95 s on.
TEST_F(RenderCommand, AnIncidentAfterTheLastFrameIsReported) {
    write(folder / "ball.toml", kBall + "velocity = [0, 9905.2, 0]\n");
    const std::vector<std::string> faster = {"--set", "world.gravity=[0,100,0]"};
    const auto render = [&](std::vector<std::string> more) {
        more.insert(more.end(), faster.begin(), faster.end());
        return film(more);
    };
    EXPECT_EQ(render({"--frames", "0..8"}).code, 0);
    for (int twice = 0; twice < 2; ++twice) {
        const Ended ended = render({});
        EXPECT_EQ(ended.code, 6);
        EXPECT_NE(ended.err.find("ball: step 57 (t = 0.950 s): body 'ball': faster"),
                  std::string::npos)
            << ended.err;
    }
    EXPECT_EQ(render({"--frames", "0..8"}).code, 0) << "it comes later";
}

/// A record of before, or of a run without an incident, has no such entry.
TEST_F(RenderCommand, ARecordWithoutAnIncidentHasNoEntryOfIt) {
    ASSERT_EQ(film({}).code, 0);
    EXPECT_EQ(contentOf(folder / "output/ball/run.json").find("incident"), std::string::npos);
}

TEST_F(RenderCommand, NeverWritesThroughASymlink) {
    write(folder / "victim", "untouched");
    fs::create_directories(folder / "out");
    fs::create_symlink(folder / "victim", folder / "out/frame_000001.png");
    EXPECT_EQ(film({"-o", "out", "--overwrite"}).code, 4);
    EXPECT_EQ(contentOf(folder / "victim"), "untouched");
}

TEST_F(RenderCommand, RawFramesGoToStandardOutput) {
    const Ended ended = film({"-o", "-", "--seconds", "0.3"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.out.size(), 3u * 4 * kWidth * kHeight);
}

TEST_F(RenderCommand, ABrokenPipeIsCode4) {
    Launch launch = small(folder.path(), {"-o", "-"});
    launch.beforeExec = [] { close(STDOUT_FILENO); };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4);
    EXPECT_NE(ended.err.find("standard output"), std::string::npos) << ended.err;
}

TEST_F(RenderCommand, AStillIsTheFilmsFrame) {
    ASSERT_EQ(film({}).code, 0);
    const Ended still = run(folder.path(), {"still", "ball.toml", "--size", "96x54", "--fps", "10",
                                            "--samples", "1", "-f", "-3", "-o", "-"});
    ASSERT_EQ(still.code, 0) << still.err;
    EXPECT_TRUE(isWhole(still.out));
    EXPECT_TRUE(still.out == contentOf(folder / "output/ball/frame_000007.png"));
}

TEST_F(RenderCommand, AStillNeedsNoFrameRate) {
    const std::vector<std::string> arguments = {"still",     "ball.toml", "--size", "96x54",
                                                "--samples", "1",         "--set",  "world.hz=100",
                                                "-t",        "0.5",       "-o",     "a.png"};
    EXPECT_EQ(run(folder.path(), arguments).code, 0);
}

TEST_F(RenderCommand, AStillIsNotReplacedUnasked) {
    const std::vector<std::string> arguments = {
        "still", "ball.toml", "--size", "96x54", "--samples", "1", "-t", "0.5", "-o", "a.png"};
    EXPECT_EQ(run(folder.path(), arguments).code, 0);
    EXPECT_EQ(run(folder.path(), arguments).code, 5);
}

TEST_F(RenderCommand, PatternsNameTheFiles) {
    ASSERT_EQ(film({"-o", "x/{scene}-##-{quality}.png", "--seconds", "0.2"}).code, 0);
    EXPECT_TRUE(fs::exists(folder / "x/ball-01-medium.png"));
}

TEST_F(RenderCommand, DoctorKnowsTheRenderer) {
    const Ended ended = run(folder.path(), {"doctor"});
    EXPECT_TRUE(ended.code == 0 || ended.code == 4);
    EXPECT_NE(ended.out.find("OpenGL"), std::string::npos) << ended.out;
}

TEST_F(RenderCommand, APlotStandsBelowThePictureAndItsCursorMoves) {
    const auto still = [&](const std::string& time) {
        const Ended ended =
            run(folder.path(), {"still", "ball.toml", "--size", "320x180", "--samples", "1", "--show",
                                "plot", "--clean", "-t", time, "-o", "-"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(ended.out.data());
        return render::decodePng({bytes, ended.out.size()});
    };
    const render::Image early = still("0"), late = still("0.7");
    ASSERT_EQ(early.width, 320);
    ASSERT_EQ(early.height, 180);
    const auto below = [](const render::Image& image) {
        return std::vector<std::uint8_t>(image.at(0, 130), image.at(0, 179));
    };
    EXPECT_NE(below(early), below(late));
}

TEST_F(RenderCommand, ASizeWithoutRoomForAPlotIsRefused) {
    const Ended ended =
        run(folder.path(), {"still", "ball.toml", "--size", "9x2", "--show", "plot", "-o", "-"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("--size 9x2: too small"), std::string::npos) << ended.err;
}

TEST_F(RenderCommand, AnotherColouringIsAnotherFilm) {
    ASSERT_EQ(film({}).code, 0);
    const Ended other = film({"--colour-by", "speed"});
    EXPECT_NE(other.code, 0);
    EXPECT_EQ(film({"--color-by", "speed", "--overwrite"}).code, 0);
    const Ended wrong = film({"--color-by", "sped"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.err.find("did you mean 'speed'"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace demos::test
