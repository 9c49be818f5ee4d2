// tests/mutants/known.txt excuses mutants of lines that exist, each with a reason.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

const std::filesystem::path kTree = IMPULSE_SOURCE_DIR;

std::string withoutSpaces(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    return text;
}

std::string codeOf(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return withoutSpaces(text.str());
}

TEST(KnownMutants, AreOfLinesThatExistAndHaveAReason) {
    std::ifstream known(kTree / "tests" / "mutants" / "known.txt");
    int count = 0;
    std::string name, reason;
    while (std::getline(known, name)) {
        if (!name.starts_with("engine/")) continue;
        ++count;
        ASSERT_TRUE(std::getline(known, reason));
        EXPECT_TRUE(reason.starts_with("  ") && reason.size() > 20) << name;
        const size_t colon = name.find(": "), arrow = name.find(" -> ");
        ASSERT_TRUE(colon < arrow && arrow != std::string::npos) << name;
        const std::string line = withoutSpaces(name.substr(colon + 2, arrow - colon - 2));
        EXPECT_NE(codeOf(kTree / name.substr(0, colon)).find(line), std::string::npos) << name;
    }
    EXPECT_GT(count, 0);
}

}  // namespace
