// The table of builds on which the bits are the same says so of enough builds, and of those that exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

std::string fileOfBuilds(const char* name) {
    std::ifstream file(std::filesystem::path(IMPULSE_SOURCE_DIR) / "tests" / "builds" / name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::multiset<std::string> foundIn(const std::string& text, const char* pattern) {
    std::multiset<std::string> found;
    const std::regex expression(pattern);
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
        found.insert((*match)[1]);
    return found;
}

TEST(TableOfBuilds, HasTwentyRowsWithEqualHashes) {
    const std::string page = fileOfBuilds("README.md");
    const auto rows = foundIn(page, R"(\n\| `([^`]+)` \|)");
    const auto equal = foundIn(page, R"(\n\| `([^`]+)` \|[^\n]*\| 8 equal \| \d{4}-\d\d-\d\d \|)");
    EXPECT_GE(rows.size(), 20u);
    EXPECT_EQ(rows, equal);
    for (const char* name : {"g++-O3", "aarch64", "riscv64", "s390x"}) EXPECT_TRUE(rows.count(name)) << name;
}

TEST(TableOfBuilds, NamesBuildsOfTheScript) {
    const auto made = foundIn(fileOfBuilds("run"), R"re(\n    Build\("([^"]+)")re");
    for (const std::string& name : foundIn(fileOfBuilds("README.md"), R"(\n\| `([^`]+)` \|)"))
        EXPECT_TRUE(made.count(name)) << name;
}

// A new library of the engine belongs to the lists of those whose machine code is examined (same_bits.sh).
TEST(MachineCode, OfEveryLibraryOfTheEngineIsExamined) {
    const auto libraries = foundIn(fileOfBuilds("../../engine/CMakeLists.txt"), R"(\nengine_library\((\w+))");
    EXPECT_GT(libraries.size(), 5u);
    EXPECT_EQ(foundIn(fileOfBuilds("../layering/CMakeLists.txt"), R"(TARGET_FILE:(\w+)>)"), libraries);
    const std::string run = fileOfBuilds("run"), list = run.substr(run.find("\nENGINE = ["));
    EXPECT_EQ(foundIn(list.substr(0, list.find(']')), R"re("(\w+)")re"), libraries);
}

}  // namespace
