// demos/figure/README.md agrees with the figures that are made.
#include <gtest/gtest.h>

#include "demos/look/type.h"
#include "tests/docs/texts.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace docs;

const fs::path kFigureFolder = demosFolder("figure");
const std::string kFigureText = readmeOf(kFigureFolder);

TEST(FigureReadme, ItsCommandsExist) {
    const std::set<std::string> lines = matches(kFigureText, R"(\nimpulse ([a-z]+[^\n]*))");
    EXPECT_EQ(lines.size(), 5u);
    for (const std::string& line : lines) {
        const std::string help = outputOf(line.substr(0, line.find(' ')) + " --help");
        for (const std::string& option : matches(line, R"( (--?[a-z]+))"))
            EXPECT_NE(help.find(option), std::string::npos) << line;
    }
}

TEST(FigureReadme, EveryCommandThatTakesAWidthIsNamedAndNoOther) {
    std::set<std::string> taking;
    for (const std::string& command : matches(outputOf("--help"), R"(\n  ([a-z]+)  )"))
        if (outputOf(command + " --help").find("--width") != std::string::npos)
            taking.insert(command);
    EXPECT_EQ(firstCells(sectionOf(kFigureText, "What each command draws")), taking);
    EXPECT_EQ(taking.size(), 5u);
}

TEST(FigureReadme, TellsThePointsThatAreDrawn) {
    const std::string table = sectionOf(kFigureText, "Type and lines");
    for (const double points : {demos::kLabelPoints, demos::kTitlePoints, demos::kCurvePoints,
                                demos::kEdgePoints, demos::kTrailPoints, demos::kGapPoints}) {
        std::ostringstream cell;
        cell << " | " << points << " |\n";
        EXPECT_NE(table.find(cell.str()), std::string::npos) << points;
    }
}

/// Makes captions with every possible line.
TEST(FigureReadme, NamesEveryLineOfACaption) {
    const support::TemporaryFolder folder;
    const std::string place = " --width 85mm --dpi 72 --caption " + (folder / "c.txt").string() +
                              " --set world.gravity=[0,-1,0] --set world.seed=2";
    std::set<std::string> written;
    for (const std::string& command :
         {"still pendulum -t 0 --show ids --colour-by speed -o " + (folder / "a.png").string(),
          "compare pendulum --vary solver.sweeps=1,2 --seconds 0.1 -o " +
              (folder / "b.png").string()}) {
        outputOf(command + place);
        const std::string text = textOf(folder / "c.txt");
        ASSERT_FALSE(text.empty()) << command;
        written.merge(matches(text, R"(\n([a-z(][a-z ()]*): )"));
        fs::remove(folder / "c.txt");
    }
    written.erase("(b)");
    EXPECT_EQ(firstCells(sectionOf(kFigureText, "The caption")), written);
}

TEST(FigureReadme, NamesEveryFileAndNoOther) {
    std::set<std::string> files;
    for (const fs::directory_entry& file : fs::directory_iterator(kFigureFolder))
        if (file.path().extension() == ".h") files.insert(file.path().stem().string());
    EXPECT_EQ(firstCells(sectionOf(kFigureText, "Files")), files);
}

}  // namespace
