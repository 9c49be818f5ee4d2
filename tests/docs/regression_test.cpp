// demos/regression/README.md agrees with the program.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "demos/regression/mutants.h"
#include "demos/scene/description.h"
#include "tests/docs/texts.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace docs;

const fs::path kRegressionFolder = demosFolder("regression");
const std::string kRegressionText = readmeOf(kRegressionFolder);

TEST(RegressionReadme, ItsTableIsRead) {
    const support::TemporaryFolder folder;
    const std::size_t begin = kRegressionText.find("```toml\n") + 8;
    std::ofstream(folder / "a.toml")
        << "format = 1\n"
        << kRegressionText.substr(begin, kRegressionText.find("```", begin) - begin)
        << "[[body]]\nname = 'ball'\nshape = { sphere = 0.5 }\n";
    const std::string out = outputOf("sim '" + (folder / "a.toml").string() + "' --hash");
    EXPECT_NE(out.find("state"), std::string::npos) << out;
    EXPECT_EQ(out.find("impulse: "), std::string::npos) << out;
}

TEST(RegressionReadme, NamesTheDefaultTolerances) {
    const demos::Tolerance tolerance;
    EXPECT_NE(kRegressionText.find(fmt::format("({} m and {} deg unless given)", tolerance.position,
                                               tolerance.angleDegrees)),
              std::string::npos)
        << kRegressionText.substr(0, 2000);
}

TEST(RegressionReadme, NamesTheDefaultGate) {
    const demos::PictureGate gate;
    const std::string text = std::regex_replace(kRegressionText, std::regex("\n"), " ");
    for (const std::string& words :
         {fmt::format("16x16 pixels has more than {} that differ by more than {} levels",
                      gate.windowPixels, gate.levels),
          fmt::format("structural similarity (SSIM) of {} or more", gate.ssim)})
        EXPECT_NE(text.find(words), std::string::npos) << words;
}

TEST(RegressionReadme, TellsOfEveryMutant) {
    std::set<std::string> mutants;
    for (const demos::Mutant& mutant : demos::mutants()) mutants.insert(mutant.name);
    const std::size_t begin = kRegressionText.find("| damage |");
    ASSERT_NE(begin, std::string::npos);
    const std::string table =
        kRegressionText.substr(begin, kRegressionText.find("\n\n", begin) - begin);
    EXPECT_EQ(matches(table, "\n\\| `([^`]+)`"), mutants);
}

TEST(RegressionReadme, ItsCommandsAndTheirOptionsExist) {
    const std::set<std::string> lines = matches(kRegressionText, R"(\nimpulse ([a-z]+[^\n]*))");
    EXPECT_GE(lines.size(), 5u);
    for (const std::string& line : lines) {
        const std::string command = line.substr(0, line.find(' '));
        const std::string help = outputOf(command + " --help");
        EXPECT_NE(help.find("impulse " + command), std::string::npos) << line;
        for (const std::string& option : matches(line, R"( (--?[a-z-]+))"))
            EXPECT_NE(help.find(option), std::string::npos) << line;
    }
}

/// Every source of the folder once, by its name without an extension.
TEST(RegressionReadme, NamesEveryFileAndNoOther) {
    std::set<std::string> files;
    for (const fs::directory_entry& file : fs::directory_iterator(kRegressionFolder))
        if (file.path().extension() == ".h") files.insert(file.path().stem().string());
    const std::size_t table = kRegressionText.find("| file | what it does |");
    ASSERT_NE(table, std::string::npos);
    std::set<std::string> named;
    for (const std::string& row : matches(kRegressionText.substr(table), R"(\n\| ([^|]+) \|)"))
        named.merge(matches(row, "`([a-z_]+)`"));
    for (const std::string& row :
         matches(kRegressionText.substr(table), R"(\n\| [^|]+ \| ([^\n]+))"))
        for (const std::string& name : matches(row, "`([a-z_]+)`"))
            if (files.count(name)) named.insert(name);
    EXPECT_EQ(named, files);
}

}  // namespace
