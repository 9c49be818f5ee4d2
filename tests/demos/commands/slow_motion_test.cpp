// Sections with `slow` in films: the same pictures as at a higher frame rate, whoever draws them.
#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

/// At 60 steps and 10 frames a second: 4 frames of 6 steps, then 12 of 3.
constexpr int kSlowFrames = 16;

class SlowMotion : public SmallFilm {
protected:
    void SetUp() override {
        write(folder / "ball.toml", kBall + "[[section]]\nat = 0\nname = 'fall'\ncaption = 'down'\n"
                                            "[[section]]\nat = 0.4\nname = 'impact'\ncaption = 'up'\n"
                                            "slow = 0.5\n");
    }
    Files drawn(const std::string& name, std::vector<std::string> more) {
        more.insert(more.end(), {"-o", name + "/####.png"});
        const Ended ended = film(std::move(more));
        EXPECT_EQ(ended.code, 0) << ended.err;
        return framesIn(folder / name);
    }
};

std::string pngOf(int frame) { return (frame < 10 ? "000" : "00") + std::to_string(frame) + ".png"; }

TEST_F(SlowMotion, ShowsTheMomentsBetweenTheFramesOfTheFilmWithoutIt) {
    const Files slow = drawn("slow", {"-j", "2"});
    ASSERT_EQ(slow.size(), static_cast<std::size_t>(kSlowFrames));
    std::string scene = contentOf(folder / "ball.toml");
    scene.erase(scene.find("slow = 0.5\n"), 11);
    write(folder / "ball.toml", scene);
    ASSERT_EQ(run(folder.path(), {"render", "ball.toml", "--size", "96x54", "--fps", "20", "--samples", "1",
                                  "-o", "fine/####.png"})
                  .code,
              0);
    const Files fine = framesIn(folder / "fine");
    for (int frame = 0; frame < kSlowFrames; ++frame) {
        const int same = frame < 4 ? 2 * frame : 8 + (frame - 4);
        EXPECT_TRUE(slow.at(pngOf(frame)) == fine.at(pngOf(same))) << frame;
    }
    EXPECT_FALSE(slow.at(pngOf(4)) == slow.at(pngOf(5)));
}

TEST_F(SlowMotion, IsTheSameInParts) {
    const Files whole = drawn("whole", {"--blur", "3"});
    ASSERT_EQ(whole.size(), static_cast<std::size_t>(kSlowFrames));
    ASSERT_EQ(run(folder.path(), {"sim", "ball.toml", "--states", "states", "--every", "7", "--quiet"}).code, 0);
    for (const char* part : {"1/3", "2/3", "3/3"})
        drawn("parts", {"--blur", "3", "--shard", part, "--states", "states", "-j", "1"});
    EXPECT_TRUE(framesIn(folder / "parts") == whole);
}

TEST_F(SlowMotion, OpensTheShutterOfAStillAsLongAsThatOfTheFilm) {
    write(folder / "ball.toml", contentOf(folder / "ball.toml") + "[camera]\norbit_deg_per_s = 90\n");
    const Files slow = drawn("slow", {"--blur", "3"});
    for (const int frame : {0, 2, 10}) {
        const std::string png = "still" + std::to_string(frame) + ".png";
        const Ended still = run(folder.path(), {"still", "ball.toml", "--frame", std::to_string(frame), "--size",
                                                "96x54", "--fps", "10", "--samples", "1", "--blur", "3", "-o", png});
        ASSERT_EQ(still.code, 0) << still.err;
        EXPECT_TRUE(contentOf(folder / png) == slow.at(pngOf(frame))) << frame;
    }
}

TEST_F(SlowMotion, CountsInStillsPostersAndPasses) {
    const Files slow = drawn("slow", {"--poster", "poster.png", "--poster-time", "0.7", "--pass", "contacts"});
    EXPECT_TRUE(contentOf(folder / "poster.png") == slow.at(pngOf(10)));  // 0.4 s + 6 frames of 0.05 s
    const Ended still = run(folder.path(), {"still", "ball.toml", "--frame", "10", "--size", "96x54", "--fps",
                                            "10", "--samples", "1", "-o", "still.png"});
    ASSERT_EQ(still.code, 0) << still.err;
    EXPECT_TRUE(contentOf(folder / "still.png") == slow.at(pngOf(10)));
    std::string all;
    for (const std::string& name : namesIn(folder / "slow" / "contacts"))
        all += contentOf(folder / "slow" / "contacts" / name);
    // Each step that touches the floor is in the contacts of one frame.
    for (int step = 46; step <= 48; ++step) {
        const std::string word = "\"step\":" + std::to_string(step) + ",";
        ASSERT_NE(all.find(word), all.npos) << step;
        EXPECT_EQ(all.find(word), all.rfind(word)) << step;
    }
    EXPECT_NE(contentOf(folder / "slow" / "passes.json").find("\"steps_per_frame\": null"), std::string::npos);
}

TEST_F(SlowMotion, MovesChaptersAndCaptions) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    write(folder / "ball.toml", contentOf(folder / "ball.toml") +
                                    "[[section]]\nat = 0.7\nname = 'again'\ncaption = 'down again'\n");
    const Ended ended = film({"-o", "one.mp4", "--captions", "one.vtt"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("13 frames, 1.3 s"), std::string::npos) << ended.out;
    EXPECT_EQ(playableFrames(folder / "one.mp4"), 13);
    const std::string captions = contentOf(folder / "one.vtt");
    for (const char* cue : {"00:00:00.000 --> 00:00:00.400\ndown\n", "00:00:00.400 --> 00:00:01.000\nup\n",
                            "00:00:01.000 --> 00:00:01.300\ndown again\n"})
        EXPECT_NE(captions.find(cue), std::string::npos) << cue << captions;
}

TEST_F(SlowMotion, ThatNeedsMoreStepsSaysSo) {
    write(folder / "ball.toml", kBall + "[[section]]\nat = 0.4\nslow = 0.05\n");
    const Ended ended = film({"-o", "slow/####.png", "--frames", "0"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("the section at 0.4 s: slow = 0.05 shows each step in 3.333 frames; with --set "
                             "world.hz=200 each frame has its own"),
              std::string::npos)
        << ended.err;
}

}  // namespace
}  // namespace demos::test
