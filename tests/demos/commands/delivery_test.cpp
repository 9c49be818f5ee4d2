// Film strips, posters, films of a given size, streams: outputs for publishing a scene.
#include <unistd.h>

#include "render/encode/ffmpeg.h"
#include "render/encode/png_read.h"
#include "tests/demos/program.h"

namespace demos::test {
namespace {

render::Image pictureIn(const std::string& png) {
    return render::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
}

class Delivery : public testing::Test {
protected:
    Delivery() { write(folder / "ball.toml", kBall); }
    Launch launch(const char* command, std::vector<std::string> more) const {
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = {command,     "ball.toml", "--fps",  "10",
                            "--samples", "1",         "--size", "96x54"};
        launch.arguments.insert(launch.arguments.end(), more.begin(), more.end());
        return launch;
    }
    Ended strip(std::vector<std::string> more) const {
        return run(launch("strip", std::move(more)));
    }
    Ended render(std::vector<std::string> more) const {
        return run(launch("render", std::move(more)));
    }
    std::ptrdiff_t filesLeft(const std::string& name) const {
        std::ptrdiff_t files = 0;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.path()))
            files += entry.path().filename().string().starts_with(name);
        return files;
    }
    TemporaryFolder folder;
};

/// Expects a refusal: its code, and a word of its only line.
void expectRefused(const Ended& ended, int code, const std::string& word) {
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
}

TEST_F(Delivery, AStripIsTheFilmsFramesInARow) {
    const Ended ended = strip({"-n", "4", "--clean"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("wrote output/ball/strip.png (4 moments, 394x58)"), std::string::npos)
        << ended.out;
    const render::Image whole = pictureIn(contentOf(folder / "output/ball/strip.png"));
    ASSERT_EQ(whole.width, 2 + 4 * 98);
    ASSERT_EQ(whole.height, 2 + 56);
    const int frames[] = {0, 3, 6, 9};
    for (int i = 0; i < 4; ++i) {
        const Ended still =
            run(launch("still", {"-f", std::to_string(frames[i]), "-o", "-", "--clean"}));
        const render::Image one = pictureIn(still.out);
        bool same = true;
        for (int y = 0; y < 54; ++y)
            same = same &&
                   std::equal(one.at(0, y), one.at(0, y) + 4 * 96, whole.at(2 + i * 98, 2 + y));
        EXPECT_TRUE(same) << "frame " << frames[i];
    }
}

TEST_F(Delivery, AStripTellsTheTimesBelow) {
    ASSERT_EQ(strip({"-n", "2", "-o", "with.png"}).code, 0);
    const render::Image labelled = pictureIn(contentOf(folder / "with.png"));
    EXPECT_EQ(labelled.height, 2 + 54 + 15 + 2);  // 10 pixels of text and 5 of space
    const std::uint8_t* paper = labelled.at(0, 0);
    int ink[2] = {0, 0};
    for (int y = 57; y < labelled.height; ++y)
        for (int x = 0; x < labelled.width; ++x)
            ink[x >= labelled.width / 2] += labelled.at(x, y)[0] + 60 < paper[0];
    EXPECT_GT(ink[0], 20);
    EXPECT_GT(ink[1], 20);
}

TEST_F(Delivery, AStripTakesTimesAndColumns) {
    const Ended ended = strip({"--times", "0,0.25,0.5", "--columns", "2", "--clean", "-o", "-"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const render::Image whole = pictureIn(ended.out);
    EXPECT_EQ(whole.width, 2 + 2 * 98);
    EXPECT_EQ(whole.height, 2 + 2 * 56);
}

TEST_F(Delivery, AStripIsNotReplacedUnasked) {
    ASSERT_EQ(strip({"-n", "1", "-o", "a.png"}).code, 0);
    const std::string before = contentOf(folder / "a.png");
    expectRefused(strip({"-n", "2", "-o", "a.png"}), 5, "--overwrite");
    EXPECT_EQ(contentOf(folder / "a.png"), before);
    EXPECT_EQ(strip({"-n", "2", "-o", "a.png", "--overwrite"}).code, 0);
}

TEST_F(Delivery, AStripThatCannotBeIsRefusedAtOnce) {
    expectRefused(strip({"-n", "0"}), 2, "1 to 100");
    expectRefused(strip({"-n", "11"}), 2, "the film has 10 frames");
    expectRefused(strip({"-n", "2", "--times", "0,1"}), 2, "--times");
    expectRefused(strip({"--times", "1,0.5"}), 2, "must increase");
    expectRefused(strip({"--times", "0.5,0.501"}), 2, "same step");
    expectRefused(strip({"--times", "soon"}), 2, "'soon'");
    expectRefused(strip({"--times", "nan"}), 2, "'nan'");
    expectRefused(strip({"-o", "a.mp4"}), 2, "ends in .png");
    const Ended wide = run(folder.path(), {"strip", "ball.toml", "--size", "6000x10", "-n", "3"});
    expectRefused(wide, 2, "at most 16384 a side");
    EXPECT_EQ(filesLeft("output"), 0);
}

TEST_F(Delivery, APosterIsAFrameOfTheFilm) {
    const Ended ended = render({"-o", "frames", "--poster", "{scene}.png"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("wrote ball.png (frame 5, t = 0.500 s)"), std::string::npos)
        << ended.out;
    EXPECT_TRUE(contentOf(folder / "ball.png") == contentOf(folder / "frames/frame_000005.png"));
    ASSERT_EQ(render({"-o", "frames", "--poster", "b.png", "--poster-time", "0.2"}).code, 0);
    EXPECT_TRUE(contentOf(folder / "b.png") == contentOf(folder / "frames/frame_000002.png"));
}

TEST_F(Delivery, CaptionsAreCuesFromSectionToSection) {
    write(folder / "ball.toml", kBall + "[[section]]\nat = 0.0\nname = 'fall'\n"
                                        "caption = 'a < b'\n[[section]]\nat = 0.2\nname = 'silent'\n"
                                        "[[section]]\nat = 0.4\nname = 'b'\ncaption = 'end'\n");
    ASSERT_EQ(render({"-o", "frames", "--captions", "{scene}.vtt"}).code, 0);
    EXPECT_EQ(contentOf(folder / "ball.vtt"),
              "WEBVTT\n\nfall\n00:00:00.000 --> 00:00:00.400\na &lt; b\n"
              "\nb\n00:00:00.400 --> 00:00:01.000\nend\n");
    expectRefused(render({"--captions", "ball.vtt"}), 5, "--overwrite");
    expectRefused(render({"--captions", "ball.srt"}), 2, "end in .vtt");
    write(folder / "ball.toml", kBall);
    expectRefused(render({"--captions", "a.vtt"}), 2, "no [[section]]");
}

TEST_F(Delivery, ThePosterOfAFilmNeedsNoFrames) {
    if (!render::haveFfmpeg()) GTEST_SKIP() << "no ffmpeg";
    ASSERT_EQ(render({"-o", "a.mp4", "--poster", "a.png"}).code, 0);
    const Ended still = run(launch("still", {"-f", "5", "-o", "-"}));
    EXPECT_TRUE(contentOf(folder / "a.png") == still.out);
}

TEST_F(Delivery, TheScenesSectionNamesThePoster) {
    const std::string first = "[[section]]\nat = 0.0\nname = \"a\"\n";
    const std::string second = "[[section]]\nat = 0.4\nname = \"b\"\nposter = ";
    const std::pair<const char*, const char*> cases[] = {
        {"\"first\"", "frame 4"}, {"\"last\"", "frame 9"}, {"0.7", "frame 7"}};
    for (const auto& [poster, frame] : cases) {
        write(folder / "ball.toml", kBall + first + second + poster + "\n");
        const Ended ended = render({"-o", "frames", "--overwrite", "--poster", "p.png"});
        EXPECT_NE(ended.out.find(frame), std::string::npos) << poster << ": " << ended.out;
    }
}

TEST_F(Delivery, APosterThatCannotBeIsRefusedAtOnce) {
    expectRefused(render({"--poster", "a.jpg"}), 2, "ends in .png");
    expectRefused(render({"--poster-time", "1"}), 2, "--poster");
    expectRefused(render({"--poster", "a.png", "--poster-time", "7"}), 2, "last frame is at 0.9 s");
    expectRefused(render({"--poster", "a.png", "--poster-time", "-1"}), 2, "0 to 100000");
    write(folder / "a.png", "precious");
    expectRefused(render({"--poster", "a.png"}), 5, "--overwrite");
    EXPECT_EQ(filesLeft("output"), 0);
    EXPECT_EQ(contentOf(folder / "a.png"), "precious");
}

TEST_F(Delivery, AFilmFitsTheSizeAskedFor) {
    if (!render::haveFfmpeg()) GTEST_SKIP() << "no ffmpeg";
    ASSERT_EQ(render({"-o", "free.gif"}).code, 0);
    const std::uintmax_t free = fs::file_size(folder / "free.gif");
    const std::string limit = std::to_string(free - 1);
    const Ended ended = render({"-o", "small.gif", "--max-size", limit});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_LT(fs::file_size(folder / "small.gif"), free);
    EXPECT_NE(ended.out.find("kB: 96x54, 10 frames/s, 128 colours)"), std::string::npos)
        << ended.out;
    EXPECT_NE(ended.err.find("256 colours: "), std::string::npos) << ended.err;
    expectRefused(render({"-o", "none.gif", "--max-size", "1K", "--quiet"}), 4, "more than 1.0 kB");
    EXPECT_EQ(filesLeft("none"), 0);
}

TEST_F(Delivery, SizesAreThousandsOfBytes) {
    for (const char* bad : {"0", "999", "8X", "-8M", "M", "", "1e6", "nan", "8 M", "2000G"})
        if (*bad) expectRefused(render({"-o", "a.gif", "--max-size", bad}), 2, "--max-size");
    expectRefused(render({"--max-size", "8M"}), 2, "-o film.gif");
    EXPECT_EQ(filesLeft("a.gif") + filesLeft("output"), 0);
}

/// A signal while the film is being fitted: it is reported, with code 130, and no file is left.
TEST_F(Delivery, AnInterruptEndsTheFitting) {
    if (!render::haveFfmpeg()) GTEST_SKIP() << "no ffmpeg";
    Launch slow =
        launch("render", {"-o", "a.webm", "--max-size", "1K", "--json", "--seconds", "9"});
    slow.awaited = "\"frame\":89,";  // the last one
    slow.signal = SIGINT;
    const Ended ended = run(slow);
    EXPECT_TRUE(ended.code == 130 || ended.code == 4) << ended.code;  // 4: it did not fit
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_EQ(filesLeft("a.webm"), 0);
}

TEST_F(Delivery, AReaderThatGoesAwayIsCode4) {
    Launch stream = launch("render", {"-o", "-", "--quiet"});
    stream.beforeExec = withoutReader(STDOUT_FILENO);
    expectRefused(run(stream), 4, "cannot write to standard output: Broken pipe");
}

}  // namespace
}  // namespace demos::test
