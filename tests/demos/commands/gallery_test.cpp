// impulse gallery: files written, kept and refused; one picture of all scenes.
#include "render/encode/png_read.h"
#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

class Gallery : public testing::Test {
protected:
    Gallery() {
        write(folder / "ball.toml", kBall);
        write(folder / "other.toml", kBall);
    }

    Launch launch(std::vector<std::string> more) const {
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = {"gallery", "--size", "96x54", "--fps", "10", "--samples", "1"};
        launch.arguments.insert(launch.arguments.end(), more.begin(), more.end());
        return launch;
    }
    Ended gallery(std::vector<std::string> more) const { return run(launch(std::move(more))); }
    fs::path made(const std::string& name) const { return folder / "output/gallery" / name; }
    bool isMade(const std::string& name) const { return fs::exists(made(name)); }
    std::string page() const { return contentOf(made("index.html")); }
    bool pageHas(const std::string& scene) const {
        return page().find("\"name\":\"" + scene + "\"") != std::string::npos;
    }

    TemporaryFolder folder;
};

bool told(const Ended& ended, const std::string& text) {
    return ended.out.find(text) != std::string::npos;
}

TEST_F(Gallery, MakesAPageAFilmAndAPosterOfEachScene) {
    const Ended ended = gallery({"pendulum", "ball.toml", "--seconds", "1"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    for (const char* name : {"pendulum", "ball"}) {
        EXPECT_TRUE(pageHas(name)) << name;
        EXPECT_TRUE(isWhole(contentOf(made(name + std::string(".png"))))) << name;
        if (haveTools()) {
            EXPECT_EQ(playableFrames(made(name + std::string(".mp4"))), kFrames);
        }
        EXPECT_NE(contentOf(made(name + std::string(".html"))).find("impulse replay"),
                  std::string::npos);
    }
    EXPECT_NE(page().find("\"replay\":true"), std::string::npos);
    EXPECT_TRUE(isMade("sheet.png"));
    EXPECT_TRUE(told(ended, "2 drawn, 0 kept")) << ended.out;
    EXPECT_EQ(page().find(folder.path().string()), std::string::npos)
        << "where the file is, is reported";
}

TEST_F(Gallery, TheSameCommandTwiceDrawsNothingTwice) {
    ASSERT_EQ(gallery({"ball.toml", "other.toml"}).code, 0);
    const auto written = fs::last_write_time(made("ball.png"));
    const Ended again = gallery({"ball.toml", "other.toml"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(told(again, "0 drawn, 2 kept")) << again.out;
    EXPECT_EQ(fs::last_write_time(made("ball.png")), written);
    const std::string replay = contentOf(made("other.html"));
    write(made("ball.png"), "torn");
    write(made("other.html"), "torn");
    EXPECT_TRUE(told(gallery({"ball.toml", "other.toml"}), "2 drawn, 0 kept"));
    EXPECT_TRUE(isWhole(contentOf(made("ball.png"))));
    EXPECT_EQ(contentOf(made("other.html")), replay);
}

TEST_F(Gallery, AnInterruptedOneGoesOn) {
    for (const int signal : {SIGINT, SIGKILL}) {
        fs::remove_all(folder / "output");
        Launch first =
            launch({"ball.toml", "other.toml", "pendulum", "bridge", "--jobs", "1", "--json"});
        first.awaited = "\"scene\":\"ball\"";
        first.signal = signal;
        const Ended ended = run(first);
        EXPECT_TRUE(signal == SIGINT ? ended.code == 130 : ended.signal == SIGKILL) << ended.err;
        EXPECT_FALSE(isMade("index.html"));
        const Ended again = gallery({"ball.toml", "other.toml", "pendulum", "bridge"});
        EXPECT_EQ(again.code, 0) << again.err;
        EXPECT_EQ(again.out.find("4 drawn"), std::string::npos) << again.out;
        for (const char* name : {"ball", "other", "pendulum", "bridge"})
            EXPECT_TRUE(pageHas(name)) << name;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "output/gallery"))
            EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
    }
}

TEST_F(Gallery, ReplacesNothingThatIsNotItsOwn) {
    for (const char* name : {"index.html", "sheet.png", "ball.png", "ball.mp4", "ball.html"}) {
        if (std::string(name) == "ball.mp4" && !haveTools()) continue;
        fs::remove_all(folder / "output");
        fs::create_directories(folder / "output/gallery");
        write(made(name), "a stranger's");
        const Ended ended = gallery({"ball.toml"});
        EXPECT_EQ(ended.code, 5) << name << ended.err;
        EXPECT_NE(ended.err.find(name), std::string::npos) << ended.err;
        EXPECT_EQ(contentOf(made(name)), "a stranger's");
        EXPECT_EQ(gallery({"ball.toml", "--overwrite"}).code, 0);
        EXPECT_NE(contentOf(made(name)), "a stranger's");
    }
}

TEST_F(Gallery, ReplaysAreLeftOutAndComeLater) {
    ASSERT_EQ(gallery({"ball.toml", "--no-films", "--no-replays"}).code, 0);
    EXPECT_FALSE(isMade("ball.html"));
    EXPECT_NE(page().find("\"replay\":false"), std::string::npos);
    EXPECT_TRUE(told(gallery({"ball.toml", "--no-films"}), "1 drawn, 0 kept"));
    EXPECT_TRUE(isMade("ball.html"));
}

TEST_F(Gallery, OtherSettingsNeedToBeAskedFor) {
    ASSERT_EQ(gallery({"ball.toml", "other.toml"}).code, 0);
    const std::string before = contentOf(made("ball.png"));
    const Ended ended = gallery({"ball.toml", "other.toml", "--theme", "dark"});
    EXPECT_EQ(ended.code, 5);
    EXPECT_NE(ended.err.find("2 scenes of another run"), std::string::npos) << ended.err;
    EXPECT_EQ(contentOf(made("ball.png")), before);
    write(folder / "ball.toml", kBall + "velocity = [1, 0, 0]\n");
    EXPECT_NE(gallery({"ball.toml", "other.toml"}).err.find("1 scene of another run"),
              std::string::npos);
    const Ended replaced = gallery({"ball.toml", "other.toml", "--overwrite"});
    EXPECT_TRUE(told(replaced, "1 drawn, 1 kept")) << replaced.out << replaced.err;
}

TEST_F(Gallery, AShorterListDropsCardsAndKeepsFiles) {
    ASSERT_EQ(gallery({"ball.toml", "other.toml"}).code, 0);
    ASSERT_EQ(gallery({"ball.toml"}).code, 0);
    EXPECT_TRUE(pageHas("ball"));
    EXPECT_FALSE(pageHas("other"));
    EXPECT_TRUE(isMade("other.png"));
    EXPECT_TRUE(told(gallery({"ball.toml", "other.toml"}), "0 drawn, 2 kept"));
    EXPECT_TRUE(pageHas("other"));
}

TEST_F(Gallery, WhatFailsIsReportedAndTheOthersAreMade) {
    write(folder / "broken.toml", "format = 1\nsecond = 3\n");
    const Ended ended = gallery({"broken.toml", "ball.toml"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.err.find("impulse: broken.toml:2:1: "), std::string::npos) << ended.err;
    EXPECT_TRUE(pageHas("ball"));
    EXPECT_FALSE(pageHas("broken"));
}

/// A scene with an incident is made as well, and reported whenever it is there.
TEST_F(Gallery, AnIncidentIsReportedAgainAndItsSceneIsMade) {
    write(folder / "comet.toml",
          kBall + "velocity = [9995, 0, 0]\n[world]\ngravity = [100, 0, 0]\n");
    for (const char* kept : {"0 kept", "2 kept"}) {
        const Ended ended = gallery({"comet.toml", "other.toml"});
        EXPECT_EQ(ended.code, 6) << ended.err;
        EXPECT_TRUE(told(ended, kept)) << ended.out;
        EXPECT_NE(ended.err.find("impulse: comet: step "), std::string::npos) << ended.err;
        EXPECT_EQ(ended.err.find("impulse: other"), std::string::npos) << ended.err;
        EXPECT_TRUE(pageHas("other") && pageHas("comet") && isMade("comet.png"));
    }
    EXPECT_EQ(gallery({"other.toml"}).code, 0);
    const Ended sheet = gallery({"comet.toml", "-o", "sheet.png"});
    EXPECT_EQ(sheet.code, 6) << sheet.err;
    EXPECT_TRUE(fs::exists(folder / "sheet.png"));
}

/// Neither a page that would open empty, nor pictures for a sheet that cannot be made.
TEST_F(Gallery, WithoutAScenePageAndSheetAreNotMade) {
    const Ended none = gallery({"nope"});
    EXPECT_EQ(none.code, 3) << none.err;
    EXPECT_TRUE(told(none, "no page")) << none.out;
    EXPECT_FALSE(isMade("index.html") || isMade("sheet.png"));
    const Ended high = run(folder.path(), {"gallery", "ball.toml", "--size", "16x16384"});
    EXPECT_EQ(high.code, 2);
    EXPECT_NE(high.err.find("use a smaller --size"), std::string::npos) << high.err;
    EXPECT_FALSE(isMade("ball.png"));
}

TEST_F(Gallery, ASheetThatStaysIsNotReportedAsWritten) {
    EXPECT_TRUE(told(gallery({"ball.toml"}), "(1 scene, 1 drawn, 0 kept), sheet.png"));
    EXPECT_TRUE(told(gallery({"ball.toml"}), "(1 scene, 0 drawn, 1 kept)\n"));
}

TEST_F(Gallery, WithoutFfmpegThereArePostersAndFilmsComeLater) {
    Launch without = launch({"ball.toml"});
    without.beforeExec = [] { setenv("PATH", "/nonexistent", 1); };
    const Ended ended = run(without);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_NE(ended.err.find("ffmpeg is not installed"), std::string::npos);
    EXPECT_TRUE(isMade("ball.png"));
    EXPECT_NE(page().find("\"film\":false"), std::string::npos);
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    EXPECT_EQ(gallery({"ball.toml"}).code, 0);
    EXPECT_TRUE(isMade("ball.mp4"));
    EXPECT_NE(page().find("\"film\":true"), std::string::npos);
}

TEST_F(Gallery, OnePictureHoldsAPosterOfEachScene) {
    const Ended ended = run(folder.path(), {"gallery", "pendulum", "ball.toml", "stack", "--size",
                                            "64x36", "--columns", "2", "-o", "scenes.png"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const std::string png = contentOf(folder / "scenes.png");
    const render::Image image =
        render::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
    EXPECT_GE(image.width, 2 * 64);
    EXPECT_LT(image.width, 3 * 64);
    EXPECT_GE(image.height, 2 * 36);
    // The middle of the first tile shows the sky, not the paper.
    EXPECT_NE(std::vector<int>(image.at(34, 6), image.at(34, 6) + 3),
              std::vector<int>(image.at(0, 0), image.at(0, 0) + 3));
    EXPECT_FALSE(fs::exists(folder / "output"));
    EXPECT_EQ(gallery({"pendulum", "-o", "scenes.png"}).code, 5) << "would overwrite";
}

TEST_F(Gallery, SaysWhatIsWrong) {
    const auto errorOf = [&](const std::vector<std::string>& arguments) {
        const Ended ended = gallery(arguments);
        EXPECT_EQ(ended.code, 2);
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        return ended.err;
    };
    EXPECT_NE(errorOf({"ball.toml", "-o", "a.jpg"}).find("ends in .png"), std::string::npos);
    write(folder / "stack.toml", kBall);
    EXPECT_NE(errorOf({"stack", "stack.toml"}).find("both be called 'stack'"), std::string::npos);
    for (const char* name : {"sheet.toml", "index.toml"}) {
        write(folder / name, kBall);
        EXPECT_NE(errorOf({name}).find("rename the file"), std::string::npos);
    }
    if (haveTools()) {
        EXPECT_NE(errorOf({"ball.toml", "--theme", "transparent"}).find("holds no alpha"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace demos::test
