/// Failures while a film is drawn: kills, full and read-only disks, ffmpeg. Complete files stay
/// complete, the same command resumes, and the message and the code say what happened.
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <random>
#include <set>

#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

class Interruption : public SmallFilm {
protected:
    /// Names that are neither frames nor the record.
    static std::set<std::string> leftovers(const fs::path& where) {
        std::set<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(where)) {
            const std::string name = entry.path().filename().string();
            if (name != "run.json" && entry.path().extension() != ".png") names.insert(name);
        }
        return names;
    }
    static void expectAllWhole(const fs::path& where) {
        for (const auto& [name, png] : framesIn(where)) EXPECT_TRUE(isWhole(png)) << name;
    }
    /// A program named ffmpeg, first on the PATH of the run.
    void replaceFfmpeg(Launch& launch, const std::string& script) {
        fs::create_directories(folder / "bin");
        write(folder / "bin/ffmpeg", "#!/bin/sh\n" + script + "\n");
        fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
        const char* path = std::getenv("PATH");
        launch.beforeExec = [bin = (folder / "bin").string(), old = std::string(path ? path : "")] {
            setenv("PATH", (bin + ":" + old).c_str(), 1);
            setenv("IMPULSE_FFMPEG_PATIENCE_MS", "300", 1);
        };
    }
};

int killsAsked() {
    const char* text = std::getenv("IMPULSE_KILLS");
    return text ? std::atoi(text) : 6;
}

// Kills the run after a random number of frames, in the middle of whatever comes next.
// For more kills: IMPULSE_KILLS=100 cli_tests --gtest_filter=Interruption.Killed*
TEST_F(Interruption, KilledAtAnyMomentTheSameCommandGivesTheSameFiles) {
    constexpr int kLong = 70;  // the record is written after fifty
    const std::vector<std::string> calm = {"-o", "calm", "--seconds", "7"};
    ASSERT_EQ(film(calm).code, 0);
    const Files expected = framesIn(folder / "calm");
    ASSERT_EQ(expected.size(), static_cast<std::size_t>(kLong));
    std::mt19937 chance(4711);
    int killed = 0;
    for (int round = 0; killed < killsAsked(); ++round) {
        const std::string name = "torn" + std::to_string(round);
        // A resumed run may be killed again; every third one is allowed to finish.
        for (int again = 0; again < 3 && killed < killsAsked(); ++again) {
            Launch launch =
                small(folder.path(), {"-o", name, "--seconds", "7", "--json", "--jobs", "2"});
            const int frame = static_cast<int>(chance() % kLong);
            launch.awaited =
                frame == 0 ? "\"event\":\"start\"" : "\"frame\":" + std::to_string(frame) + ",";
            launch.signal = SIGKILL;
            const Ended ended = run(launch);
            killed += ended.signal == SIGKILL;
            if (ended.code == 0) break;  // that frame existed already, or was the last
            ASSERT_EQ(ended.signal, SIGKILL) << ended.err;
            if (fs::exists(folder / name)) expectAllWhole(folder / name);
        }
        const Ended resumed = film({"-o", name, "--seconds", "7"});
        ASSERT_EQ(resumed.code, 0) << resumed.err;
        ASSERT_EQ(framesIn(folder / name), expected) << "round " << round;
        EXPECT_EQ(leftovers(folder / name), std::set<std::string>{});
        fs::remove_all(folder / name);
    }
    RecordProperty("kills", killed);
}

TEST_F(Interruption, ASecondSignalEndsAtOnceAndTearsNothing) {
    Launch launch = small(folder.path(), {"-o", "out", "--seconds", "600", "--json"});
    launch.awaited = "\"frame\":4,";
    launch.awaitedCall = [](pid_t child) {
        kill(child, SIGSTOP);  // so that both signals are pending when it continues
        kill(child, SIGINT);
        kill(child, SIGTERM);
        kill(child, SIGCONT);
    };
    const Ended ended = run(launch);
    EXPECT_TRUE(ended.code == 130 || ended.signal == SIGINT || ended.signal == SIGTERM)
        << ended.code << " " << ended.signal;
    expectAllWhole(folder / "out");
}

/// For a child process: its own namespace, in which it may mount.
bool ownMounts() {
    return unshare(CLONE_NEWNS) == 0 &&
           mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

bool mayMount() {
    const pid_t child = fork();
    if (child == 0) _exit(ownMounts() ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Both the run and the inspection of the disk happen where the small disk is mounted.
TEST_F(Interruption, AFullDiskKeepsTheFramesBeforeWhole) {
    if (!mayMount()) GTEST_SKIP() << "this user may not mount a small disk";
    fs::create_directories(folder / "disk");
    fs::create_directories(folder / "kept");
    Launch launch = small(folder.path(), {"-o", "disk/out", "--seconds", "600"});
    launch.beforeExec = [disk = (folder / "disk").string(), kept = (folder / "kept").string()] {
        if (!ownMounts() || mount("small", disk.c_str(), "tmpfs", 0, "size=64k") != 0) _exit(125);
        const pid_t run = fork();  // becomes the program; this process inspects the disk afterwards
        if (run == 0) return;
        int status = 0;
        waitpid(run, &status, 0);
        std::error_code error;
        fs::copy(disk, kept, fs::copy_options::recursive, error);
        _exit(WIFEXITED(status) ? WEXITSTATUS(status) : 124);
    };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4) << ended.err;
    EXPECT_NE(ended.err.find("disk full"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("disk/out/"), std::string::npos) << ended.err;
    const Files frames = framesIn(folder / "kept/out");
    EXPECT_GT(frames.size(), 1u);
    EXPECT_LT(frames.size(), 200u);
    for (const auto& [name, png] : frames) EXPECT_TRUE(isWhole(png)) << name;
    EXPECT_EQ(leftovers(folder / "kept/out"), std::set<std::string>{});
}

TEST_F(Interruption, AReadOnlyFolderIsCode4) {
    if (!mayMount()) GTEST_SKIP() << "this user may not mount";
    fs::create_directories(folder / "disk");
    for (const char* output : {"disk", "disk/new", "disk/film.mp4"}) {
        Launch launch = small(folder.path(), {"-o", output});
        launch.beforeExec = [disk = (folder / "disk").string()] {
            if (!ownMounts() || mount("small", disk.c_str(), "tmpfs", MS_RDONLY, nullptr) != 0)
                _exit(125);
        };
        const Ended ended = run(launch);
        EXPECT_EQ(ended.code, 4) << output << ": " << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find("Read-only file system"), std::string::npos) << ended.err;
    }
}

TEST_F(Interruption, AFullDevice) {
    Launch launch = small(folder.path(), {"-o", "-"});
    launch.beforeExec = [] { dup2(open("/dev/full", O_WRONLY | O_CLOEXEC), STDOUT_FILENO); };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4);
    EXPECT_NE(ended.err.find("standard output: disk full"), std::string::npos) << ended.err;
}

TEST_F(Interruption, TwoRunsInOneFolderAreToldApart) {
    Launch first = small(folder.path(), {"-o", "out", "--seconds", "600", "--json"});
    first.awaited = "\"frame\":3,";
    Ended second;
    first.awaitedCall = [&](pid_t child) {
        second = film({"-o", "out", "--seconds", "600"});
        kill(child, SIGINT);
    };
    EXPECT_EQ(run(first).code, 130);
    EXPECT_EQ(second.code, 5) << second.err;
    EXPECT_NE(second.err.find("another run"), std::string::npos) << second.err;
    expectAllWhole(folder / "out");
}

TEST_F(Interruption, AKilledFilmLeavesNothingForTheNextRun) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    Launch launch = small(folder.path(), {"-o", "film.mp4", "--seconds", "600", "--json"});
    launch.awaited = "\"frame\":9,";
    launch.signal = SIGKILL;
    EXPECT_EQ(run(launch).signal, SIGKILL);
    EXPECT_FALSE(fs::exists(folder / "film.mp4"));
    const Ended again = film({"-o", "film.mp4"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(playableFrames(folder / "film.mp4"), kFrames);
    EXPECT_EQ(leftovers(folder.path()), (std::set<std::string>{"ball.toml", "film.mp4"}));
}

TEST_F(Interruption, TwoRunsOfOneFilmAreToldApart) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    Launch first = small(folder.path(), {"-o", "film.mp4", "--seconds", "600", "--json"});
    first.awaited = "\"frame\":3,";
    Ended second;
    first.awaitedCall = [&](pid_t child) {
        second = film({"-o", "film.mp4", "--overwrite"});
        kill(child, SIGINT);
    };
    EXPECT_EQ(run(first).code, 130);
    EXPECT_EQ(second.code, 5) << second.err;
    EXPECT_NE(second.err.find("another run"), std::string::npos) << second.err;
    EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"ball.toml"});
}

TEST_F(Interruption, AFilmThatAppearsMeanwhileIsKept) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    Launch launch = small(folder.path(), {"-o", "film.mp4", "--seconds", "4", "--json"});
    launch.awaited = "\"frame\":3,";
    launch.awaitedCall = [&](pid_t) { write(folder / "film.mp4", "another's"); };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 5) << ended.err;
    EXPECT_NE(ended.err.find("'film.mp4' was created in the meantime"), std::string::npos) << ended.err;
    EXPECT_EQ(fs::file_size(folder / "film.mp4"), 9u);
    EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{"ball.toml", "film.mp4"}));
}

TEST_F(Interruption, AnFfmpegThatSaysMoreThanItWritesIsCode4) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    const std::string counts = "cat > /dev/null; echo frame=" + std::to_string(kFrames) + "; echo progress=end";
    for (const std::string wrote : {"true", "for f; do :; done; echo ftyp > \"${f#file:}\""})
        for (const char* film : {"film.mp4", "film.webm", "film.webp", "film.apng"}) {
            Launch launch = small(folder.path(), {"-o", film});
            replaceFfmpeg(launch, "[ \"$1\" = -version ] && exit 0\n" + counts + "; " + wrote);
            const Ended ended = run(launch);
            EXPECT_EQ(ended.code, 4) << film << ended.err;
            EXPECT_NE(ended.err.find("left no complete film"), std::string::npos) << ended.err;
            EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{"ball.toml", "bin"}));
        }
}

TEST_F(Interruption, ADyingFfmpegIsCode4AndTheFramesBesideStay) {
    Launch launch = small(folder.path(), {"-o", "film.mp4", "-o", "frames", "--seconds", "60"});
    replaceFfmpeg(launch, "head -c 100000 > /dev/null; echo 'Encoder broke' >&2; exit 7");
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4) << ended.err;
    EXPECT_NE(ended.err.find("status 7: Encoder broke"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "film.mp4"));
    EXPECT_GE(framesIn(folder / "frames").size(), 4u);
    expectAllWhole(folder / "frames");
    const Ended without = film({"-o", "frames", "--seconds", "60"});
    EXPECT_EQ(without.code, 0) << without.err;
    EXPECT_NE(without.out.find(" kept"), std::string::npos) << without.out;
}

TEST_F(Interruption, AHangingFfmpegIsEndedAndReported) {
    Launch launch = small(folder.path(), {"-o", "film.mp4", "--seconds", "600"});
    replaceFfmpeg(launch, "[ \"$1\" = -version ] && exit 0\nexec sleep 1000");
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4) << ended.err;
    EXPECT_NE(ended.err.find("ffmpeg did nothing"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "film.mp4"));
    EXPECT_EQ(leftovers(folder.path()), (std::set<std::string>{"ball.toml", "bin"}));
}

// The signal comes when all frames have been sent; the busy child would be waited for without an end.
TEST_F(Interruption, ASignalWhileFfmpegFinishesEndsBoth) {
    Launch launch = small(folder.path(), {"-o", "film.mp4"});
    replaceFfmpeg(launch, "[ \"$1\" = -version ] && exit 0\ncat > /dev/null; kill -INT $PPID; while :; do :; done");
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 130) << ended.err;
    EXPECT_NE(ended.err.find("no film was written"), std::string::npos) << ended.err;
    EXPECT_EQ(leftovers(folder.path()), (std::set<std::string>{"ball.toml", "bin"}));
}

}  // namespace
}  // namespace demos::test
