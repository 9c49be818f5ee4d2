// Figures for papers, made as by a user: sizes, type, captions, refusals.
#include "render/encode/png_read.h"
#include "tests/demos/program.h"

namespace demos::test {
namespace {

class Figure : public testing::Test {
protected:
    Figure() { write(folder / "ball.toml", kBall); }
    Ended impulse(std::vector<std::string> arguments) const {
        return run(folder.path(), std::move(arguments));
    }
    render::Image picture(const std::string& name) const {
        const std::string bytes = contentOf(folder / name);
        return render::decodePng(
            {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    }
    /// The scene, and what was made.
    std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
    }
    TemporaryFolder folder;
};

/// Small on the machine, 8 pt on paper: 60 mm at 96 dpi are 227 pixels.
const std::vector<std::string> kPaper = {"--width", "60mm", "--dpi", "96"};

std::vector<std::string> small(std::vector<std::string> first,
                               const std::vector<std::string>& more = {}) {
    first.insert(first.end(), kPaper.begin(), kPaper.end());
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

/// Pixels per metre as recorded in the file, 0 if it has none.
std::uint32_t perMeter(const std::string& png) {
    const std::size_t at = png.find("pHYs");
    if (at == std::string::npos) return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 4; i < 8; ++i) value = value << 8 | static_cast<std::uint8_t>(png[at + i]);
    return value;
}

TEST_F(Figure, IsAsWideAsAskedForInEveryCommand) {
    const std::vector<std::vector<std::string>> commands = {
        small({"still", "ball.toml", "-o", "a.png"}),
        small({"strip", "ball.toml", "-n", "3", "-o", "a.png"}),
        small({"plot", "ball.toml", "-o", "a.png"}),
        small({"compare", "ball.toml", "--vary", "solver.nudges=0,4", "-o", "a.png"}),
        small({"compare", "ball.toml", "--vary", "solver.nudges=0,4", "--no-film", "--plot",
               "a.png"}),
        small({"sweep", "ball.toml", "--over", "solver.sweeps=1..3", "-o", "a.png"})};
    for (const std::vector<std::string>& command : commands) {
        const Ended ended = impulse(command);
        ASSERT_EQ(ended.code, 0) << command[0] << ": " << ended.err;
        EXPECT_NE(ended.out.find("wrote a.caption.txt\n"), std::string::npos) << ended.out;
        EXPECT_EQ(picture("a.png").width, 227) << command[0];
        EXPECT_EQ(perMeter(contentOf(folder / "a.png")), 3780u) << command[0];
        EXPECT_FALSE(contentOf(folder / "a.caption.txt").empty());
        EXPECT_EQ(files(), 3) << command[0];
        fs::remove(folder / "a.png");
        fs::remove(folder / "a.caption.txt");
    }
}

TEST_F(Figure, TheSizeGivesTheRatio) {
    ASSERT_EQ(impulse(small({"still", "ball.toml", "-o", "a.png", "--size", "200x100"})).code, 0);
    EXPECT_EQ(picture("a.png").height, 114);
    ASSERT_EQ(impulse(small({"plot", "ball.toml", "--what", "contacts", "-o", "b.svg", "--size",
                             "3x2"}))
                  .code,
              0);
    EXPECT_NE(contentOf(folder / "b.svg").find("width=\"60mm\" height=\"39.912mm\""),
              std::string::npos);
}

/// Rows from the first to the last that has ink darker than `level`, within the columns.
int inkHeight(const render::Image& image, int left, int right, int top, int bottom) {
    int first = bottom, last = top - 1;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            if (image.at(x, y)[0] < 160) first = std::min(first, y), last = y;
    return last - first + 1;
}

/// The digits of "t = 0.00 s" below a picture and of a chart's axis have one size at any width.
TEST_F(Figure, LettersOfAStripAndOfAChartAreOfOneSize) {
    for (const char* width : {"60mm", "120mm"}) {
        ASSERT_EQ(impulse({"strip", "ball.toml", "--times", "0", "--width", width, "--dpi", "300",
                           "--size", "160x40", "--samples", "1", "-o", "strip.png", "--overwrite"})
                      .code,
                  0);
        const render::Image strip = picture("strip.png");
        const int below = strip.width * 40 / 160 + 2;
        const int label = inkHeight(strip, 0, strip.width, below, strip.height);
        EXPECT_NEAR(label, 25, 1) << width;  // a digit of 8 pt: 0.742 em of 33.3 pixels, and rims
        ASSERT_EQ(impulse({"plot", "ball.toml", "--what", "contacts", "--width", width, "--dpi",
                           "300", "-o", "chart.png", "--overwrite"})
                      .code,
                  0);
        const render::Image chart = picture("chart.png");
        // the ticks' row, below their marks and above "time (s)"
        const int digits =
            inkHeight(chart, 0, chart.width, chart.height - 114, chart.height - 65);
        EXPECT_NEAR(digits, label, 1) << width;
    }
}

TEST_F(Figure, TransparentOnesHaveAlphaOrNoRectangle) {
    for (const char* command : {"still", "strip", "plot"}) {
        ASSERT_EQ(impulse(small({command, "ball.toml", "-o", std::string(command) + ".png"},
                                {"--theme", "transparent"}))
                      .code,
                  0);
        EXPECT_EQ(picture(std::string(command) + ".png").at(0, 0)[3], 0) << command;
    }
    ASSERT_EQ(impulse(small({"compare", "ball.toml", "--vary", "solver.nudges=0,4", "-o", "c.png",
                             "--plot", "d.svg", "--theme", "transparent"}))
                  .code,
              0);
    const render::Image panels = picture("c.png");
    EXPECT_EQ(panels.at(0, panels.height - 1)[3], 0);
    EXPECT_EQ(contentOf(folder / "d.svg").find("<rect x=\"0.00\" y=\"0.00\""), std::string::npos);
    ASSERT_EQ(impulse(small({"plot", "ball.toml", "-o", "e.svg"})).code, 0);
    EXPECT_NE(contentOf(folder / "e.svg").find("<rect x=\"0.00\" y=\"0.00\""), std::string::npos);
}

TEST_F(Figure, IsForPrintUnlessAThemeIsGiven) {
    ASSERT_EQ(impulse(small({"strip", "ball.toml", "-n", "1", "-o", "a.png"})).code, 0);
    const render::Image print = picture("a.png");
    EXPECT_EQ(print.at(0, print.height - 1)[0], 255);
    EXPECT_NE(contentOf(folder / "a.caption.txt").find("\ntheme: print\n"), std::string::npos);
    ASSERT_EQ(
        impulse(small({"strip", "ball.toml", "-n", "1", "-o", "b.png"}, {"--theme", "dark"})).code,
        0);
    EXPECT_LT(picture("b.png").at(0, print.height - 1)[0], 80);
}

TEST_F(Figure, IsTheSameBytesEveryTime) {
    const std::vector<std::vector<std::string>> commands = {
        small({"still", "ball.toml", "-o", "a.png", "--show", "impulses,stats"}),
        small({"plot", "ball.toml", "-o", "a.png"}),
        small({"sweep", "ball.toml", "--over", "solver.sweeps=1..3", "--plot", "a.png"})};
    for (std::vector<std::string> command : commands) {
        command.push_back("--overwrite");
        ASSERT_EQ(impulse(command).code, 0);
        const std::string png = contentOf(folder / "a.png");
        const std::string caption = contentOf(folder / "a.caption.txt");
        ASSERT_EQ(impulse(command).code, 0);
        EXPECT_TRUE(png == contentOf(folder / "a.png")) << command[0];
        EXPECT_EQ(caption, contentOf(folder / "a.caption.txt"));
    }
}

TEST_F(Figure, TheCaptionTellsWhatMadeIt) {
    const Ended ended = impulse(small({"still", "ball.toml", "-t", "1", "--set",
                                       "solver.substeps=9", "--show", "impulses", "-o", "a.png"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    const std::string text = contentOf(folder / "a.caption.txt");
    EXPECT_TRUE(text.starts_with("a ball. t = 1 s; red arrows: impulses")) << text;
    const std::size_t state = ended.out.find("state ");
    for (const std::string& line :
         {std::string("\nsize on paper: 60 x 33.8 mm, 227x128 pixels at 96 dpi\n"),
          std::string("\nsolver: preset steady; substeps=9\n"),
          std::string("\nset: solver.substeps=9\n"), std::string("\nsteps a second: 60\n"),
          std::string("\nstep: 60\n"), "\nstate: " + ended.out.substr(state + 6, 16) + "\n",
          std::string("\ncommand: impulse still ball.toml -t 1 ")})
        EXPECT_NE(text.find(line), std::string::npos) << line << "in\n" << text;
    EXPECT_EQ(text.find(folder.path().string()), std::string::npos);
}

TEST_F(Figure, ACaptionMayHaveANameOfItsOwnAndNoWidth) {
    ASSERT_EQ(impulse({"still", "ball.toml", "--size", "64x36", "--samples", "1", "-o", "a.png",
                       "--caption", "deep/words.txt"})
                  .code,
              0);
    EXPECT_NE(contentOf(folder / "deep/words.txt").find("\nsize: 64x36 pixels\n"),
              std::string::npos);
    EXPECT_EQ(perMeter(contentOf(folder / "a.png")), 0u);
    EXPECT_FALSE(fs::exists(folder / "a.caption.txt"));
}

TEST_F(Figure, AComparisonNamesItsRuns) {
    ASSERT_EQ(impulse(small({"compare", "ball.toml", "--case", "free: solver.nudges=0", "--case",
                             "nudged: solver.nudges=4", "-t", "0.5", "-o", "a.png"}))
                  .code,
              0);
    const std::string text = contentOf(folder / "a.caption.txt");
    EXPECT_TRUE(text.starts_with("A ball: (a) free; (b) nudged. t = 0.5 s; below: penetration over "
                                 "time.\n"))
        << text;
    EXPECT_NE(text.find("\n(b): nudged: solver.nudges=4 (preset steady; nudges=4, 60 steps a "
                        "second), state "),
              std::string::npos)
        << text;
    const render::Image with = picture("a.png");
    ASSERT_EQ(impulse(small({"compare", "ball.toml", "--case", "free: solver.nudges=0", "--case",
                             "nudged: solver.nudges=4", "--no-strip", "-o", "b.png"}))
                  .code,
              0);
    EXPECT_GT(with.height, picture("b.png").height + 60);
}

/// A run that diverges is shown in its last state, and reported.
TEST_F(Figure, ADivergedRunIsReported) {
    const Ended ended = impulse(small({"compare", "ball.toml", "--seconds", "20", "--vary",
                                       "body.ball.velocity=[0,0,0],[9999,0,0]", "--set",
                                       "world.gravity=[0,0,0]", "-o", "a.png"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(contentOf(folder / "a.caption.txt").find(", diverged: ball: step "),
              std::string::npos);
}

TEST_F(Figure, WhatIsThereStaysAndBothOrNoneAreWritten) {
    for (const char* there : {"a.png", "a.caption.txt"}) {
        write(folder / there, "precious");
        for (const std::vector<std::string>& command :
             {small({"still", "ball.toml", "-o", "a.png"}),
              small({"plot", "ball.toml", "-o", "a.png"}),
              small({"compare", "ball.toml", "--vary", "solver.nudges=0,4", "-o", "a.png"}),
              small({"sweep", "ball.toml", "--over", "solver.sweeps=1..2", "--plot", "a.png"})}) {
            const Ended ended = impulse(command);
            EXPECT_EQ(ended.code, 5) << command[0] << ended.err;
            EXPECT_TRUE(ended.out.empty()) << ended.out;
            EXPECT_EQ(files(), 2) << command[0];
        }
        EXPECT_EQ(contentOf(folder / there), "precious");
        fs::remove(folder / there);
    }
}

struct BadFigure {
    std::vector<std::string> arguments;
    int code;
    const char* part;
};

TEST_F(Figure, WhatCannotBeIsRefusedInOneLine) {
    const std::vector<std::string> two = {"compare", "ball.toml", "--vary", "solver.nudges=0,4"};
    const auto compare = [&](std::vector<std::string> more) {
        more.insert(more.begin(), two.begin(), two.end());
        return more;
    };
    const std::vector<BadFigure> rows = {
        {{"still", "ball.toml", "--width", "wide"}, 2, "85mm, 8.5cm"},
        {{"still", "ball.toml", "--width", "85m"}, 2, "85mm, 8.5cm"},
        {{"still", "ball.toml", "--width", "0"}, 2, "10mm to 2000mm"},
        {{"still", "ball.toml", "--width", "-85mm"}, 2, "10mm to 2000mm"},
        {{"still", "ball.toml", "--width", "9m"}, 2, "8.5cm"},
        {{"still", "ball.toml", "--dpi", "300"}, 2, "--width 85mm"},
        {{"still", "ball.toml", "--width", "85mm", "--dpi", "0"}, 2, "72 to 2400"},
        {{"still", "ball.toml", "--width", "85mm", "--dpi", "many"}, 2, "--dpi"},
        {{"still", "ball.toml", "--width", "2000mm", "--dpi", "300"}, 2, "use --dpi 208"},
        {{"still", "ball.toml", "--width", "85mm", "--size", "1x99"}, 2, "at most 16384 per side"},
        {{"still", "ball.toml", "--width", "85mm", "--caption", "-"}, 2, "needs a file"},
        {{"still", "ball.toml", "--width", "85mm", "-o", "a.png", "--caption", "./a.png"},
         2,
         "the figure itself"},
        {{"still", "ball.toml", "--caption", "ball.toml"}, 2, "the scene itself"},
        {{"strip", "ball.toml", "-n", "10", "--columns", "10", "--width", "10mm", "--dpi", "72"},
         2,
         "16 a side"},
        {{"plot", "ball.toml", "-o", "a.png", "--width", "500mm", "--dpi", "800"},
         2,
         "million pixels"},
        {{"render", "ball.toml", "--width", "85mm"}, 2, "unknown option '--width'"},
        {compare({"--width", "85mm", "-o", "a.mp4"}), 2, "ends in .png"},
        {compare({"--width", "85mm", "-o", "a.png", "-o", "b.png"}), 2, "one picture"},
        {compare({"--width", "85mm", "--no-film"}), 2, "--plot FILE"},
        {compare({"--no-film", "-o", "a.png", "--plot", "b.svg"}), 2, "leave one of them out"},
        {compare({"--width", "85mm", "-o", "a.png", "--plot", "./a.png", "--caption", "c.txt"}),
         2,
         "both be 'a.png'"},
        {compare({"--width", "85mm", "-o", "b.png", "--plot", "a.svg", "--caption", "a.svg"}),
         2,
         "--caption FILE"},
        {compare({"--width", "85mm", "-o", "a.png", "-t", "99"}), 2, "give --seconds 99"},
        {compare({"--width", "39mm", "-o", "a.png"}), 2, "a chart needs 40mm"},
        {{"plot", "ball.toml", "--width", "39mm", "-o", "a.svg"}, 2, "a chart needs 40mm"},
        {{"plot", "ball.toml", "--width", "85mm", "--size", "1000x90", "-o", "a.svg"},
         2,
         "--size 1000x353 or higher"},
        {{"still", "ball.toml", "--width", "85mm", "--size", "1000x10", "-o", "a.png"},
         2,
         "at least 5 mm high: use --size 1000x59"},
        {compare({"--width", "85mm", "-o", "a.png", "--plot", "a.svg"}), 2, "another name"},
        {compare({"--width", "85mm", "-o", "a.png", "-t", "1e5", "--set", "world.hz=100000"}), 2,
         "steps away"},
        {compare({"-t", "0.5"}), 2, "give --width"},
        {compare({"--caption", "a.txt"}), 2, "--width or --plot"},
        {{"sweep", "ball.toml", "--over", "solver.sweeps=1..2", "--width", "85mm"}, 2, "-o FIGURE"},
    };
    for (const BadFigure& row : rows) {
        const Ended ended = impulse(row.arguments);
        const std::string line = row.arguments[0] + " ... " + row.arguments.back();
        EXPECT_EQ(ended.code, row.code) << line << ": " << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find(row.part), std::string::npos) << line << ": " << ended.err;
        EXPECT_EQ(files(), 1) << line;
    }
}

/// Type keeps its size, so statistics do not fit into a small picture; that is reported.
TEST_F(Figure, WhatHasNoRoomIsReported) {
    const Ended ended = impulse(small({"still", "ball.toml", "--show", "stats", "-o", "a.png"}));
    EXPECT_EQ(ended.code, 0);
    EXPECT_NE(ended.err.find("stats: no room in a picture of 60 x 34 mm"), std::string::npos)
        << ended.err;
    EXPECT_EQ(contentOf(folder / "a.caption.txt").find("stats\n"), std::string::npos);
    ASSERT_EQ(impulse(small({"still", "ball.toml", "-o", "plain.png"})).code, 0);
    EXPECT_NE(picture("a.png").pixels, picture("plain.png").pixels);  // the first line is there
    const Ended wide = impulse({"still", "ball.toml", "--show", "stats", "--width", "170mm",
                                "--dpi", "72", "-o", "b.png"});
    EXPECT_TRUE(wide.err.empty()) << wide.err;
}

/// A legend would cover what it explains; wider pictures, and those with named colours, have it.
TEST_F(Figure, ASmallPictureHasItsLegendInTheCaption) {
    const auto pixelsOf = [&](const char* width, const char* show) {
        const std::string file = std::string(width) + show + ".png";
        EXPECT_EQ(impulse({"still", "ball.toml", "-t", "0", "--show", show, "--width", width,
                           "--dpi", "72", "-o", file})
                      .code,
                  0);
        return picture(file).pixels;
    };
    EXPECT_EQ(pixelsOf("119mm", "contacts"), pixelsOf("119mm", "normals"));
    EXPECT_NE(pixelsOf("121mm", "contacts"), pixelsOf("121mm", "normals"));
    EXPECT_NE(contentOf(folder / "119mmcontacts.caption.txt").find("; pink dots: contacts"),
              std::string::npos);
}

TEST_F(Figure, JsonNamesTheCaption) {
    const Ended ended = impulse(small({"still", "ball.toml", "-o", "a.png", "--json"}));
    EXPECT_NE(ended.out.find(R"({"event":"caption","file":"a.caption.txt"})"), std::string::npos)
        << ended.out;
}

}  // namespace
}  // namespace demos::test
