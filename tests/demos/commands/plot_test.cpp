#include "render/encode/png.h"
#include "tests/demos/program.h"

namespace demos::test {
namespace {

class Plot : public testing::Test {
protected:
    Plot() { write(folder / "ball.toml", kBall); }
    Ended plot(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"plot", "ball.toml"});
        return run(folder.path(), arguments);
    }
    bool isSvg(const std::string& name) const {
        const std::string text = contentOf(folder / name);
        return text.starts_with("<svg xmlns=") && text.ends_with("</svg>\n");
    }
    bool isPng(const std::string& name, int width, int height) const {
        const std::string bytes = contentOf(folder / name);
        return render::pngIsWhole(
            {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, width, height);
    }
    /// The scene, and what is named.
    long files() const { return std::distance(fs::directory_iterator(folder.path()), {}); }
    TemporaryFolder folder;
};

TEST_F(Plot, WritesAnSvgNamedAfterTheScene) {
    const Ended ended = plot({});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(isSvg("output/ball.svg"));
    EXPECT_NE(ended.out.find("wrote output/ball.svg ("), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("next: impulse render ball.toml"), std::string::npos) << ended.out;
    const std::string svg = contentOf(folder / "output/ball.svg");
    EXPECT_NE(svg.find(">ball: energy<"), std::string::npos);
    EXPECT_NE(svg.find(">time (s)<"), std::string::npos);
    EXPECT_EQ(svg.find("joint separation"), std::string::npos);  // there are no joints
}

TEST_F(Plot, WritesEveryFileByItsEndingAndSize) {
    const Ended ended = plot({"-o", "deep/a.svg", "-o", "b.png", "--size", "320x200", "--theme",
                              "dark", "--what", "energy"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(isSvg("deep/a.svg"));
    EXPECT_TRUE(isPng("b.png", 320, 200));
    EXPECT_NE(contentOf(folder / "deep/a.svg").find("viewBox=\"0 0 320 200\""), std::string::npos);
}

TEST_F(Plot, EveryChartCanBeAskedFor) {
    for (const char* what : {"energy", "penetration", "separation", "contacts", "impulse",
                             "residual", "energy,contacts,impulse"}) {
        EXPECT_EQ(plot({"-o", "a.svg", "--what", what, "--quiet"}).code, 0) << what;
        EXPECT_TRUE(isSvg("a.svg")) << what;
    }
}

TEST_F(Plot, WhatIsAskedForByNameSaysNoDataWhereThereIsNone) {
    EXPECT_EQ(plot({"-o", "a.svg", "--what", "separation"}).code, 0);
    EXPECT_NE(contentOf(folder / "a.svg").find(">no data<"), std::string::npos);
}

TEST_F(Plot, IsTheSameFileEveryTime) {
    plot({"-o", "a.png", "-o", "a.svg"});
    const std::string png = contentOf(folder / "a.png"), svg = contentOf(folder / "a.svg");
    plot({"-o", "a.png", "-o", "a.svg"});
    EXPECT_TRUE(png == contentOf(folder / "a.png"));
    EXPECT_TRUE(svg == contentOf(folder / "a.svg"));
}

TEST_F(Plot, SetAndSecondsChangeWhatIsPlayed) {
    plot({"-o", "a.svg", "--seconds", "0.5"});
    plot({"-o", "b.svg", "--seconds", "0.5", "--set", "world.gravity=[0,-1,0]"});
    EXPECT_FALSE(contentOf(folder / "a.svg") == contentOf(folder / "b.svg"));
}

struct BadPlot {
    const char* name;
    std::vector<std::string> arguments;
    int code;
    const char* part;
};

TEST_F(Plot, BadOptionsAreOneLineAndLeaveNothing) {
    const std::vector<BadPlot> rows = {
        {"what", {"--what", "enrgy"}, 2, "did you mean 'energy'"},
        {"what, second", {"--what", "energy,magic"}, 2, "known are: energy"},
        {"ending", {"-o", "a.jpg"}, 2, ".svg or .png"},
        {"no ending", {"-o", "a"}, 2, ".svg or .png"},
        {"standard output", {"-o", "-"}, 2, ".svg or .png"},
        {"empty", {"-o", ""}, 2, "give it a value"},
        {"second ending", {"-o", "a.svg", "-o", "a.pdf"}, 2, ".svg or .png"},
        {"twice", {"-o", "a.svg", "-o", "a.svg"}, 2, "another --output"},
        {"size", {"--size", "0x9"}, 2, "1 to 16384"},
        {"large", {"-o", "a.png", "--size", "16384x16384"}, 2, "million pixels"},
        {"theme", {"--theme", "drak"}, 2, "did you mean 'dark'"},
        {"option", {"--wat", "energy"}, 2, "did you mean '--what'"},
        {"seconds", {"--seconds", "nan"}, 2, "above 0"},
        {"set", {"--set", "world.hz=abc"}, 3, "world.hz=abc"},
        {"folder", {"-o", "ball.toml/a.svg"}, 4, "ball.toml"},
    };
    for (const BadPlot& row : rows) {
        const Ended ended = plot(row.arguments);
        EXPECT_EQ(ended.code, row.code) << row.name << ": " << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find(row.part), std::string::npos) << row.name << ": " << ended.err;
        EXPECT_TRUE(ended.out.empty()) << ended.out;
        EXPECT_EQ(files(), 1) << row.name;
    }
}

TEST_F(Plot, ADivergedRunIsCode6AndStillDrawn) {
    write(folder / "ball.toml", kBall + "velocity = [0, 9999, 0]\n");
    for (const char* command : {"plot", "sim"}) {
        const Ended ended =
            run(folder.path(), {command, "ball.toml", "--set", "world.gravity=[0,100,0]",
                                *command == 'p' ? "-o" : "--plot", "a.svg"});
        EXPECT_EQ(ended.code, 6) << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_TRUE(isSvg("a.svg"));
        fs::remove(folder / "a.svg");
    }
}

TEST_F(Plot, InterruptedItWritesWhatItHas) {
    Launch launch;
    launch.folder = folder.path();
    launch.arguments = {"plot", "ball.toml", "--seconds", "100000", "-o", "a.svg"};
    launch.beforeExec = [] {
        const pid_t plotting = getpid();
        if (fork() != 0) return;
        sleep(1);  // s: it prints nothing during the run that a test could wait for
        kill(plotting, SIGINT);
        _exit(0);
    };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 130) << ended.err;
    EXPECT_NE(ended.err.find("to run it again: impulse plot ball.toml"), std::string::npos);
    EXPECT_TRUE(isSvg("a.svg"));
}

TEST_F(Plot, JsonNamesTheFiles) {
    const Ended ended = plot({"-o", "a.svg", "--json"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_NE(ended.out.find(R"({"event":"plot","file":"a.svg","charts":)"), std::string::npos)
        << ended.out;
}

TEST_F(Plot, SimDrawsBesideItsTables) {
    const Ended ended =
        run(folder.path(), {"sim", "ball.toml", "--csv", "a.csv", "--plot", "a.png"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(fs::exists(folder / "a.csv"));
    EXPECT_TRUE(contentOf(folder / "a.png").starts_with("\x89PNG"));
    EXPECT_NE(ended.out.find("wrote a.png ("), std::string::npos) << ended.out;
}

TEST_F(Plot, SimRefusesABadPlotBeforeItPlays) {
    for (const char* file : {"a.txt", "-"}) {
        const Ended ended =
            run(folder.path(), {"sim", "ball.toml", "--csv", "a.csv", "--plot", file});
        EXPECT_EQ(ended.code, 2);
        EXPECT_NE(ended.err.find(".svg or .png"), std::string::npos) << ended.err;
        EXPECT_EQ(files(), 1);
    }
    const Ended same =
        run(folder.path(), {"sim", "ball.toml", "--csv", "a.svg", "--plot", "a.svg"});
    EXPECT_EQ(same.code, 2);
    EXPECT_EQ(same.errorLines(), 1) << same.err;
    EXPECT_EQ(files(), 1);
}

TEST(PlotHelp, ShowsThreeExamplesFirstAndIsCompleted) {
    const Ended ended = run(fs::temp_directory_path(), {"plot", "--help"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_TRUE(ended.out.starts_with("Examples:\n  impulse plot ")) << ended.out;
    for (const char* word : {"--what", "--theme", "--size", "residual", ".svg"})
        EXPECT_NE(ended.out.find(word), std::string::npos) << word;
    const Ended completion = run(fs::temp_directory_path(), {"completion", "bash"});
    EXPECT_NE(completion.out.find("plot) words=\""), std::string::npos);
}

}  // namespace
}  // namespace demos::test
