// demos/regression/in-ci.md: its jobs, commands and table agree with the program.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include "tests/docs/texts.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace docs;

const fs::path kRoot = IMPULSE_SOURCE_DIR;
const std::string kPage = textOf(kRoot / "demos/regression/in-ci.md");

/// From the heading to the next one.
std::string section(const std::string& heading) {
    const std::size_t begin = kPage.find("\n## " + heading + "\n");
    if (begin == std::string::npos) return {};
    return kPage.substr(begin, kPage.find("\n## ", begin + 1) - begin);
}

/// The lines of a job that build the program, recognised by their first words.
std::set<std::string> building(const std::string& job) {
    return matches(job, R"(\n +- (?:run: )?((?:apt-get|git clone|/impulse/|cmake) ?[^\n]+))");
}

TEST(InCi, ItsCommandsAndTheirOptionsExist) {
    const std::set<std::string> lines =
        matches(kPage, R"(\n(?: *- (?:run: )?)?impulse ([a-z]+[^\n#]*))");
    EXPECT_GE(lines.size(), 8u);
    for (const std::string& line : lines) {
        const std::string command = line.substr(0, line.find(' '));
        const std::string help = outputOf(command + " --help");
        EXPECT_NE(help.find("impulse " + command), std::string::npos) << line;
        for (const std::string& option : matches(line, R"( (--?[a-z-]+))"))
            EXPECT_FALSE(matches(help, "(" + option + R"()[ ,\n])").empty()) << line;
    }
}

TEST(InCi, ItsJobsBuildInTheSameWay) {
    const std::set<std::string> github = building(section("GitHub Actions"));
    EXPECT_EQ(github, building(section("GitLab")));
    EXPECT_EQ(github.size(), 6u);
    EXPECT_TRUE(github.count("/impulse/.ci/install build"));
    EXPECT_NE(textOf(kRoot / ".ci/packages").find("\nbuild "), std::string::npos);
    EXPECT_NE(textOf(kRoot / "CMakeLists.txt").find("option(IMPULSE_TESTS "), std::string::npos);
}

// The jobs keep the folder that the program writes to.
TEST(InCi, ItsJobsKeepTheResults) {
    const std::string help = outputOf("test --help");
    for (const char* heading : {"GitHub Actions", "GitLab"})
        for (const std::string& kept : matches(section(heading), R"(\bpaths?:\s+(?:- )?(\S+))"))
            EXPECT_NE(help.find("default: " + kept), std::string::npos) << heading << ": " << kept;
    EXPECT_NE(section("GitHub Actions").find("if: always()"), std::string::npos);
    EXPECT_NE(section("GitLab").find("when: always"), std::string::npos);
    EXPECT_NE(section("GitLab").find("junit: output/test/junit.xml"), std::string::npos);
}

TEST(InCi, NamesEveryKeywordOfTheFunctionAndNoOther) {
    const std::string source = textOf(kRoot / "demos/regression/impulse_add_snapshot_test.cmake");
    const std::size_t parsed = source.find("cmake_parse_arguments(PARSE_ARGV 0 ARG");
    ASSERT_NE(parsed, std::string::npos);
    const std::string list = source.substr(parsed + 38, source.find(')', parsed) - parsed - 38);
    const std::set<std::string> named = matches(section("CTest"), R"(\n\| `([A-Z]+)` \|)");
    EXPECT_EQ(named, matches(list, R"(([A-Z]+))"));
    EXPECT_EQ(named.size(), 8u);
}

TEST(InCi, ShowsTheExamplesOwnLines) {
    const std::string example = textOf(kRoot / "demos/examples/snapshot_tests/CMakeLists.txt");
    const std::string lines = R"(\n((?:enable_testing|find_package|impulse_add_[a-z_]+)\([^)]*\)))";
    EXPECT_EQ(matches(section("CTest"), lines), matches(example, lines));
    EXPECT_EQ(matches(example, lines).size(), 3u);
}

/// The lines of all `run: |` of an action, as bash gets them; `inputs`: lines that set its variables.
std::string scriptOf(const std::string& action, const std::string& inputs) {
    std::string script = "set -eo pipefail\n" + inputs;
    std::istringstream lines(action);
    bool within = false;
    for (std::string line; std::getline(lines, line);) {
        within = within && (line.empty() || line.starts_with("        "));
        if (within) script += line + "\n";
        within = within || line == "      run: |";
    }
    return script;
}

int exitOf(const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// As a job runs it, with the program installed: a new scene passes, a changed one fails, and both are
// in the step's summary.
TEST(InCi, ItsActionTestsScenesAndShowsWhatDiffers) {
    const support::TemporaryFolder folder;
    const fs::path actions = kRoot / ".github/actions/impulse-test/action.yml";
    const std::string script = scriptOf(
        textOf(actions), "SCENES='\nscenes'; OPTIONS='--size 64x36\n--jobs 1'; RESULTS=results\n");
    EXPECT_NE(script.find("command -v impulse"), std::string::npos) << script;
    std::ofstream(folder / "action.sh") << script;
    fs::create_directories(folder / "bin");
    fs::create_symlink(IMPULSE_BINARY, folder / "bin/impulse");
    fs::create_directories(folder / "scenes");
    const auto test = [&folder](double height) {
        std::ofstream(folder / "scenes/drop.toml")
            << "format = 1\nseconds = 0.1\n[snapshot]\ntimes = [0.1]\n"
               "[[body]]\nname = 'floor'\nfixed = true\nshape = { plane = [0, 1, 0] }\n"
               "[[body]]\nname = 'ball'\nshape = { sphere = 0.5 }\nat = [0, " << height << ", 0]\n";
        const std::string at = folder.path().string();
        return exitOf("cd '" + at + "' && env -u CI GITHUB_ACTIONS=true GITHUB_WORKSPACE='" + at +
                      "' GITHUB_SERVER_URL=https://github.com GITHUB_REPOSITORY=me/it GITHUB_SHA=abc "
                      "GITHUB_STEP_SUMMARY='" + at + "/summary.md' PATH=\"$PWD/bin:$PATH\" "
                      "bash action.sh > log 2>&1");
    };
    EXPECT_EQ(test(2.0), 0) << textOf(folder / "log");
    EXPECT_EQ(test(2.5), 1) << textOf(folder / "log");
    const std::string summary = textOf(folder / "summary.md");
    for (const char* part : {"1 scene: 1 new", "1 scene: 1 failed", "#### drop: failed",
                             "![t0.1.png](https://github.com/me/it/raw/abc/scenes/"})
        EXPECT_NE(summary.find(part), std::string::npos) << part << " in\n" << summary;
}

}  // namespace
