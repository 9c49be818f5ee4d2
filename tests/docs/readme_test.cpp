// The README agrees with the program: scenes, commands, links.
#include <gtest/gtest.h>

#include "demos/film/film_strip.h"
#include "demos/text/file_content.h"
#include "render/encode/png_read.h"
#include "tests/docs/texts.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace docs;

const std::string kRootText = readmeOf(IMPULSE_SOURCE_DIR);
const std::string kScenesText = readmeOf(demosFolder("scenes"));

TEST(ScenesReadme, NamesEveryBuiltInSceneAndNoOther) {
    const std::set<std::string> listed =
        matches(outputOf("list --json"), R"re("scene":"([a-z-]+)")re");
    EXPECT_GE(listed.size(), 34u);
    EXPECT_EQ(matches(kScenesText, R"(\n\| `([a-z-]+)` \|)"), listed);
}

TEST(Readme, OpensWithTheTwoCommands) {
    const std::size_t demos = kRootText.find("demos/run"), tests = kRootText.find("tests/run");
    ASSERT_NE(demos, std::string::npos);
    ASSERT_NE(tests, std::string::npos);
    EXPECT_LT(demos, kRootText.find("\n## "));
    EXPECT_LT(tests, kRootText.find("\n## "));
}

TEST(Readme, ItsCommandsExist) {
    const std::set<std::string> commands = matches(kRootText, R"(\nimpulse ([a-z]+))");
    EXPECT_GE(commands.size(), 5u);
    for (const std::string& command : commands)
        EXPECT_NE(outputOf(command + " --help").find("impulse " + command), std::string::npos)
            << command;
}

/// Has the size that the command below it gives for today's scenes, and is small enough for a page.
TEST(ScenesReadme, ItsGalleryHoldsEveryScene) {
    const std::string command = R"(`impulse gallery -o (\.github/gallery\.png --size \d+x\d+ --columns \d+)`)";
    const std::set<std::string> found = matches(kScenesText, command);
    ASSERT_EQ(found.size(), 1u);
    int width = 0, height = 0, columns = 0;
    ASSERT_EQ(std::sscanf(found.begin()->c_str(), ".github/gallery.png --size %dx%d --columns %d",
                          &width, &height, &columns),
              3);
    const auto scenes = matches(outputOf("list --json"), R"re("scene":"([a-z-]+)")re").size();
    const demos::StripLayout layout =
        demos::stripLayout(static_cast<int>(scenes), columns, {width, height}, true);
    const std::vector<std::uint8_t> png =
        demos::contentOf(fs::path(IMPULSE_SOURCE_DIR) / ".github/gallery.png");
    EXPECT_LE(png.size(), 500'000u);
    const render::Image image = render::decodePng(png);
    EXPECT_EQ(image.width, layout.width);
    EXPECT_EQ(image.height, layout.height);
    EXPECT_NE(outputOf("gallery --help").find("--columns"), std::string::npos);
}

/// The text of a fenced block.
std::string blockOf(const std::string& language) {
    const std::string begin = "\n```" + language + "\n";
    const std::size_t at = kRootText.find(begin);
    if (at == std::string::npos) return {};
    const std::size_t first = at + begin.size();
    return kRootText.substr(first, kRootText.find("```", first) - first);
}

TEST(Readme, ItsSceneIsOne) {
    const std::string scene = blockOf("toml");
    ASSERT_FALSE(scene.empty());
    const support::TemporaryFolder folder;
    std::ofstream(folder.path() / "my.toml") << scene;
    const std::string said = outputOf("sim " + (folder.path() / "my.toml").string());
    EXPECT_NE(said.find("my: 240 steps"), std::string::npos) << said;
}

TEST(Readme, ItsLinesOfCppAreOfTheExample) {
    const std::string example =
        textOf(fs::path(IMPULSE_SOURCE_DIR) / "demos/examples/engine_alone/main.cpp");
    std::istringstream lines(blockOf("cpp"));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        if (line.ends_with(';')) line.pop_back();
        EXPECT_NE(example.find(line), std::string::npos) << line;
    }
    EXPECT_GE(count, 8);
}

TEST(Readme, ShowsTheExamplesOwnLines) {
    const std::string example =
        textOf(fs::path(IMPULSE_SOURCE_DIR) / "demos/examples/engine_and_render/CMakeLists.txt");
    const std::string lines = R"(\n((?:find_package|target_link_libraries)\([^)]*\)))";
    EXPECT_EQ(matches(kRootText, lines), matches(example, lines));
    EXPECT_EQ(matches(kRootText, lines).size(), 2u);
}

TEST(DemosReadme, NamesEveryOverlayAndNoOther) {
    const std::string help = outputOf("render --help");
    const std::size_t start = help.find("overlays, with commas:");
    ASSERT_NE(start, std::string::npos);
    const std::string list = help.substr(start + 22, help.find(';', start) - start - 22);
    const std::string readme = textOf(fs::path(IMPULSE_SOURCE_DIR) / "demos" / "README.md");
    const std::size_t table = readme.find("## What `--show` adds");
    ASSERT_NE(table, std::string::npos);
    const std::string section = readme.substr(table, readme.find("\n## ", table) - table);
    const std::set<std::string> named = matches(section, R"(\n\| `([a-z]+)` \|)");
    EXPECT_EQ(named, matches(list, R"(([a-z]+))"));
    EXPECT_GE(named.size(), 15u);
}

const std::string kDemosText = readmeOf(fs::path(IMPULSE_SOURCE_DIR) / "demos");

TEST(DemosReadme, ItsExitCodesAreThoseOfTheHelp) {
    const std::string help = outputOf("--help");
    const std::size_t at = help.find("Exit codes:");
    ASSERT_NE(at, std::string::npos);
    const std::set<std::string> codes = matches(help.substr(at), R"((?:: |,\s)(\d+) [a-z])");
    EXPECT_EQ(matches(kDemosText, R"(\n\| (\d+) \|)"), codes);
    EXPECT_EQ(codes.size(), 9u);
}

TEST(DemosReadme, NamesTheCommandsThatReportAnIncident) {
    const std::set<std::string> simulating = firstCells(sectionOf(kDemosText, "Incidents"));
    EXPECT_EQ(simulating.size(), 15u);
    for (const std::string& command : simulating)
        EXPECT_NE(outputOf(command + " --help").find("impulse " + command), std::string::npos)
            << command;
}

/// Three balls that fall with 9995 m/s are faster than 10 km/s in step 31.
TEST(DemosReadme, ShowsAnIncidentAsItIsReported) {
    const support::TemporaryFolder folder;
    std::ofstream(folder / "ball.toml")
        << "format = 1\nseconds = 1\n[[repeat]]\ncount = 3\nstep = [9, 0, 0]\n"
           "body = { name = \"ball{i}\", shape = { sphere = 0.5 }, "
           "velocity = [0, -9995.013, 0] }\n";
    const std::string said = outputOf("plot '" + (folder / "ball.toml").string() + "' -o '" +
                                      (folder / "ball.svg").string() + "'");
    const std::size_t at = said.find("impulse: ");
    ASSERT_NE(at, std::string::npos) << said;
    const std::string line = std::regex_replace(said.substr(at, said.find('\n', at) - at),
                                                std::regex("ball\\d"), "ball");
    EXPECT_NE(kDemosText.find("\n" + line + "\n"), std::string::npos) << line;
    const std::string alone = line.substr(9, line.find(" (and") - 9);
    EXPECT_NE(readmeOf(demosFolder("regression")).find("a new incident: " + alone + "\n"),
              std::string::npos)
        << alone;
}

TEST(Readme, ItsLinksLeadSomewhere) {
    for (const char* file :
         {"README.md", "engine/README.md", "render/README.md", "demos/README.md",
          "demos/scene/README.md", "demos/scenes/README.md", "demos/film/README.md",
          "demos/mjcf/README.md", "demos/export/README.md", "demos/figure/README.md",
          "demos/regression/README.md", "demos/regression/in-ci.md", "demos/slides/README.md",
          "tests/README.md"}) {
        const fs::path path = fs::path(IMPULSE_SOURCE_DIR) / file;
        for (const std::string& link : matches(textOf(path), R"(\]\(([^)#:]+)\))"))
            EXPECT_TRUE(fs::exists(path.parent_path() / link)) << file << ": " << link;
    }
}

}  // namespace
