// Every block of the pages for newcomers works, in the order of the page. A block whose first line is
// `# FILE` begins that file, others are added to the last one; commands run in the same folder.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "tests/docs/texts.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace docs;

struct Block {
    std::string language, text;
};

std::vector<Block> blocksOf(const std::string& page) {
    std::vector<Block> blocks;
    const std::regex fence("```(toml|xml|sh)\n([^`]*)```");
    for (std::sregex_iterator i(page.begin(), page.end(), fence), end; i != end; ++i)
        blocks.push_back({(*i)[1], (*i)[2]});
    return blocks;
}

/// Small pictures: films of a page are large by default.
std::string runnable(const std::string& command) {
    static const std::regex film("^impulse (render|compare|slides|still|strip) ");
    const bool drawn = std::regex_search(command, film) && command.find("--width") == std::string::npos;
    const std::string program = "'" + std::string(IMPULSE_BINARY) + "'";
    return std::regex_replace(command, std::regex("^impulse"), program) +
           (drawn ? " --size 160x90" : "");
}

class Newcomers : public testing::TestWithParam<const char*> {
protected:
    void write(const Block& block) {
        std::string text = block.text;
        std::smatch name;
        if (std::regex_search(text, name, std::regex("^# ([a-z-]+\\.(toml|xml))\n"))) {
            file_ = folder_ / name[1].str();
            text = name.suffix();
        }
        std::ofstream(file_, std::ios::app) << text;
    }

    void run(const std::string& command) {
        const std::string line = "cd '" + folder_.path().string() + "' && { " + runnable(command) +
                                 "; } > log 2>&1";
        EXPECT_EQ(std::system(line.c_str()), 0) << command << "\n" << textOf(folder_ / "log");
    }

    support::TemporaryFolder folder_;
    fs::path file_;
};

TEST_P(Newcomers, FindThatEveryBlockWorks) {
    const std::vector<Block> blocks = blocksOf(textOf(demosFolder("scenes") / GetParam()));
    ASSERT_GE(blocks.size(), 10u);
    for (const Block& block : blocks) {
        if (block.language != "sh") {
            write(block);
            continue;
        }
        std::istringstream commands(block.text);
        for (std::string command; std::getline(commands, command);) run(command);
    }
}

INSTANTIATE_TEST_SUITE_P(Pages, Newcomers, testing::Values("first-scene.md", "recipes.md"),
                         [](const auto& page) {
                             return std::string(page.param) == "recipes.md" ? "Recipes" : "FirstScene";
                         });

}  // namespace
