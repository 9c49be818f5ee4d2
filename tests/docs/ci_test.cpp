// demos/regression/in-ci.md: its jobs, commands and table agree with the program.
#include <gtest/gtest.h>

#include "tests/docs/texts.h"

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

}  // namespace
