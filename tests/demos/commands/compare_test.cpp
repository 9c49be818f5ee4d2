// impulse compare and impulse sweep, as a user runs them.
#include <sstream>

#include "render/encode/png_read.h"
#include "tests/demos/program.h"

namespace demos::test {
namespace {

class Compare : public testing::Test {
protected:
    Compare() { write(folder / "ball.toml", kBall); }
    Ended compare(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        return run(folder.path(), arguments);
    }
    Ended sweep(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "sweep");
        return run(folder.path(), arguments);
    }
    render::Image picture(const std::string& name) {
        const std::string bytes = contentOf(folder / name);
        return render::decodePng(
            {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    }
    TemporaryFolder folder;
};

const std::vector<std::string> kFilm = {"--size",    "320x180", "--fps",     "10",
                                        "--samples", "1",       "--seconds", "0.3"};

std::vector<std::string> with(std::vector<std::string> first,
                              const std::vector<std::string>& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

/// Of the mark of an incident, in the half of the picture that begins at `left`.
int redPixels(const render::Image& image, int left) {
    int count = 0;
    for (int y = 0; y < image.height / 2; ++y)
        for (int x = left; x < left + image.width / 2; ++x) {
            const std::uint8_t* pixel = image.at(x, y);
            count += pixel[0] > 170 && pixel[1] < 90 && pixel[2] < 80;
        }
    return count;
}

TEST_F(Compare, PrintsATableAndDrawsPanelsSideBySide) {
    const Ended ended = compare(
        with({"ball.toml", "--vary", "world.gravity=[0,-9.81,0],[0,0,0]", "-o", "film"}, kFilm));
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("gravity=[0,0,0]"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("speed (m/s)"), std::string::npos) << ended.out;
    EXPECT_TRUE(fs::exists(folder / "film/frame_000002.png"));
    const render::Image last = picture("film/frame_000002.png");
    EXPECT_EQ(last.width, 320);
    EXPECT_EQ(last.height, 180);
    // by then, one panel's ball has fallen and the other's has not
    int different = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 150; ++x)
            different += !std::equal(last.at(x, y), last.at(x, y) + 3, last.at(x + 160, y));
    EXPECT_GT(different, 50);
}

// The chart's axis lies below the last row of so low a strip; its cursor was drawn there all the same.
TEST_F(Compare, TheCursorStaysWithinALowStrip) {
    for (const char* size : {"100x56", "128x72"}) {
        const Ended ended = compare({"ball.toml", "--vary", "solver.nudges=0,4", "--size", size, "--samples", "1",
                                     "-o", std::string("film") + size});
        EXPECT_EQ(ended.code, 0) << size << ended.err;
    }
}

TEST_F(Compare, WhatCannotBeWrittenIsRefusedBeforeAnythingIsPlayed) {
    write(folder / "there.mp4", "a film");
    for (const std::string command : {"compare", "sweep"}) {
        const std::vector<std::string> varied =
            command == "compare" ? std::vector<std::string>{"--vary", "solver.nudges=0,4"}
                                 : std::vector<std::string>{"--over", "solver.nudges=0..4"};
        const Ended there = run(
            folder.path(), with(with({command, "ball.toml", "-o", "there.mp4"}, varied), kFilm));
        EXPECT_EQ(there.code, 5) << there.err;
        EXPECT_TRUE(there.out.empty()) << there.out;  // no table
        const Ended large = run(folder.path(), with({command, "ball.toml", "-o", "f", "--size",
                                                     "16384x16384", "--jobs", "256"}, varied));
        EXPECT_EQ(large.code, 4) << large.err;
        EXPECT_TRUE(large.out.empty()) << large.out;
    }
    EXPECT_EQ(contentOf(folder / "there.mp4"), "a film");
}

TEST_F(Compare, ASecondRunKeepsEveryFrame) {
    const std::vector<std::string> arguments =
        with({"ball.toml", "--vary", "solver.nudges=0,4", "-o", "film"}, kFilm);
    ASSERT_EQ(compare(arguments).code, 0);
    const Ended again = compare(arguments);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("3 kept"), std::string::npos) << again.out;
}

TEST_F(Compare, GivesJson) {
    const Ended ended =
        compare({"ball.toml", "--no-film", "--json", "--vary", "solver.nudges=0,4"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 2);
    EXPECT_NE(ended.out.find(R"("label":"nudges=4","settings":["solver.nudges=4"],"drift":)"),
              std::string::npos)
        << ended.out;
}

TEST_F(Compare, TakesCasesThatGoTogether) {
    const Ended ended =
        compare({"ball.toml", "--no-film", "--case", "coarse: solver.substeps=1 solver.sweeps=4",
                 "--case", "fine: solver.substeps=4 solver.sweeps=1 solver.min_sweeps=1"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("\nfine "), std::string::npos) << ended.out;
}

TEST_F(Compare, ADivergedPanelStaysAndIsSaid) {
    const Ended ended =
        compare(with({"ball.toml", "--vary", "body.ball.velocity=[0,0,0],[9999,0,0]", "--set",
                      "body.ball.mass=1", "-o", "film"},
                     kFilm));
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err.find(": step "), std::string::npos) << ended.err;
    const Ended fast =
        compare(with({"ball.toml", "--vary", "body.ball.velocity=[0,0,0],[9999,0,0]", "--set",
                      "world.gravity=[100,0,0]", "--no-strip", "-o", "fast"},
                     kFilm));
    EXPECT_EQ(fast.code, 0) << fast.err;
    EXPECT_NE(fast.err.find("velocity=[9999,0,0]: ball: step 1 (t = 0.017 s): body 'ball': "),
              std::string::npos)
        << fast.err;
    const render::Image marked = picture("fast/frame_000002.png");
    EXPECT_EQ(redPixels(marked, 0), 0);
    EXPECT_GT(redPixels(marked, marked.width / 2), 10);
    const Ended far =
        compare({"ball.toml", "--no-film", "--seconds", "60", "--vary",
                 "body.ball.velocity=[0,0,0],[9999,0,0]", "--set", "world.gravity=[0,0,0]"});
    EXPECT_EQ(far.code, 0) << far.err;
    EXPECT_NE(far.out.find("diverged"), std::string::npos) << far.out;
}

TEST_F(Compare, RefusesWhatCannotBeCompared) {
    const std::pair<std::vector<std::string>, std::string> bad[] = {
        {{}, "clamping, caching"},
        {{"ball.toml"}, "give two to four"},
        {{"ball.toml", "--vary", "solver.sweeps=1"}, "give two to four"},
        {{"ball.toml", "--vary", "solver.sweeps=1,2,3,4,5"}, "give two to four"},
        {{"ball.toml", "--vary", "solver.sweeps"}, "KEY=VALUE"},
        {{"ball.toml", "--case", "a: b"}, "LABEL: KEY=VALUE"},
        {{"clamping", "--vary", "solver.sweeps=1,2"}, "a built-in comparison"},
        {{"ball.toml", "--vary", "solver.sweeps=1,2", "--measure", "sped"}, "did you mean 'speed'"},
    };
    for (const auto& [arguments, text] : bad) {
        const Ended ended = compare(with(arguments, {"--no-film"}));
        EXPECT_EQ(ended.code, 2) << text;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find(text), std::string::npos) << ended.err;
    }
    const Ended unknown = compare({"ball.toml", "--vary", "solver.sweep=1,2"});
    EXPECT_EQ(unknown.code, 3);
    EXPECT_NE(unknown.err.find("did you mean 'sweeps'?"), std::string::npos) << unknown.err;
}

TEST_F(Compare, ListsWhatIsBuiltIn) {
    const Ended ended = compare({"--list"});
    EXPECT_EQ(ended.code, 0);
    for (const char* name : {"clamping", "caching", "nudges", "pgs", "sweeps", "substeps"})
        EXPECT_NE(ended.out.find(name), std::string::npos) << name;
}

TEST_F(Compare, SweepWritesATableAPlotAndAGrid) {
    const Ended ended = sweep(with({"ball.toml", "--over", "world.hz=30,60,120", "--csv", "a.csv",
                                    "--plot", "a.svg", "-o", "grid"},
                                   kFilm));
    EXPECT_EQ(ended.code, 0) << ended.err;
    const std::string csv = contentOf(folder / "a.csv");
    EXPECT_TRUE(csv.starts_with("world.hz,drift,speed,penetration,")) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
    EXPECT_NE(contentOf(folder / "a.svg").find("world.hz"), std::string::npos);
    EXPECT_EQ(picture("grid/frame_000000.png").width, 320);
}

TEST_F(Compare, SweepSaysWhichSettingNeedsWholeNumbers) {
    const Ended ended = sweep({"ball.toml", "--over", "solver.sweeps=0..2:0.5"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(
        ended.err.find("--over solver.sweeps=0.5: sweeps is 0.5; it should be a whole number"),
        std::string::npos)
        << ended.err;
    EXPECT_EQ(sweep({"ball.toml"}).code, 2);
    EXPECT_EQ(sweep({"ball.toml", "--over", "solver.sweeps=1..4", "--plot", "a.gif"}).code, 2);
}

/// A row without the time of a step, which varies from run to run.
std::string withoutTimes(const std::string& csv) {
    std::string text;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t last = line.rfind(','), ms = line.rfind(',', last - 1);
        text += line.substr(0, ms) + line.substr(last) + "\n";
    }
    return text;
}

TEST_F(Compare, ASweepInPartsGivesTheTableOfOneRun) {
    const std::vector<std::string> words = {"ball.toml", "--over", "solver.sweeps=1..7",
                                            "--seconds", "0.5"};
    ASSERT_EQ(sweep(with(words, {"--csv", "one.csv"})).code, 0);
    for (const char* shard : {"3/3", "1/3"})
        ASSERT_EQ(sweep(with(words, {"--csv", "parts.csv", "--shard", shard})).code, 0);
    EXPECT_FALSE(fs::exists(folder / "parts.csv"));
    const Ended missing = sweep(with(words, {"--csv", "parts.csv", "--merge"}));
    EXPECT_EQ(missing.code, 7);
    EXPECT_EQ(missing.errorLines(), 1);
    EXPECT_NE(missing.err.find("2 of 3 parts are complete; missing: 2"), std::string::npos)
        << missing.err;
    EXPECT_NE(missing.out.find("to do: impulse sweep ball.toml --over solver.sweeps=1..7 "
                               "--seconds 0.5 --csv parts.csv --shard 2/3\n"),
              std::string::npos)
        << missing.out;
    ASSERT_EQ(sweep(with(words, {"--shard", "2/3"})).code, 0);
    EXPECT_EQ(sweep(with(words, {"--shard", "2/3"})).out, "part 2 of 3 is complete already\n");
    const Ended merged =
        sweep(with(words, {"--csv", "parts.csv", "--plot", "parts.svg", "--merge"}));
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_EQ(withoutTimes(contentOf(folder / "parts.csv")),
              withoutTimes(contentOf(folder / "one.csv")));
    EXPECT_TRUE(fs::exists(folder / "parts.svg"));

    const Ended other = sweep(with(words, {"--set", "world.hz=120", "--merge"}));
    EXPECT_EQ(other.code, 7);
    EXPECT_NE(other.err.find("of another run: 1 2 3"), std::string::npos) << other.err;
    EXPECT_EQ(sweep(with(words, {"--set", "world.hz=120", "--shard", "1/3"})).code, 5);
    write(folder / "output/ball-sweep.parts/002-of-003.json", "{\"runs\":[{}]}");
    const Ended torn = sweep(with(words, {"--merge"}));
    EXPECT_EQ(torn.code, 7);
    EXPECT_NE(torn.err.find("damaged or incomplete: 2"), std::string::npos) << torn.err;
    EXPECT_EQ(sweep(with(words, {"--shard", "1/8"})).code, 2);
    EXPECT_EQ(sweep(with(words, {"--shard", "1/2", "--merge"})).code, 2);
}

TEST_F(Compare, AComparisonInPartsGivesTheChartOfOneRun) {
    const std::vector<std::string> words = {"ball.toml", "--vary", "solver.nudges=0,4",
                                            "--no-film", "--plot"};
    ASSERT_EQ(compare(with(words, {"one.svg"})).code, 0);
    for (const char* shard : {"2/2", "1/2"})
        ASSERT_EQ(compare(with(words, {"parts.svg", "--parts", "p", "--shard", shard})).code, 0);
    ASSERT_EQ(compare(with(words, {"parts.svg", "--parts", "p", "--merge"})).code, 0);
    EXPECT_EQ(contentOf(folder / "parts.svg"), contentOf(folder / "one.svg"));
    EXPECT_FALSE(contentOf(folder / "one.svg").empty());
}

TEST_F(Compare, ASweepMarksTheRunsWhoseExpectationsFailed) {
    write(folder / "high.toml", kBall + "[[expect]]\nwhat = 'height'\nof = 'ball'\nabove = 1\n");
    const std::vector<std::string> whole = {"high.toml", "--over", "world.gravity=[0,-1,0],[0,-10,0]"};
    const Ended ended = sweep(whole);
    EXPECT_EQ(ended.code, 0) << ended.err;
    const std::size_t second = ended.out.find("gravity = [0,-10,0]");
    EXPECT_EQ(ended.out.substr(0, second).find("expectation failed"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.substr(second).find("  expectation failed\n"), std::string::npos) << ended.out;
    EXPECT_NE(ended.err.find("gravity = [0,-10,0]: the expectation failed: least height of ball"),
              std::string::npos)
        << ended.err;
    // The same from parts.
    for (const char* part : {"1/2", "2/2"})
        EXPECT_EQ(sweep(with(whole, {"--shard", part})).code, 0);
    const Ended merged = sweep(with(whole, {"--merge"}));
    EXPECT_EQ(merged.err, ended.err);
}

}  // namespace
}  // namespace demos::test
