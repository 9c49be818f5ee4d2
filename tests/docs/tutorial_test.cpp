// Every block of the pages for newcomers works, in the order of the page. A block whose first line
// is
// `# FILE` begins that file, others are added to the last one; commands run in the same folder.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "demos/text/file_content.h"
#include "render/encode/png_read.h"
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

/// The page's own picture of a command that writes it; else a path that does not exist.
fs::path shownBelow(const std::string& command) {
    std::smatch name;
    if (!std::regex_search(command, name, std::regex("-o ([a-z_]+\\.png)"))) return "none";
    return demosFolder("scenes") / "pictures" / name[1].str();
}

/// Small pictures: films of a page are large by default. What the page shows has the page's size.
std::string runnable(const std::string& command) {
    static const std::regex film("^impulse (render|compare|slides|still|strip) ");
    const bool drawn =
        std::regex_search(command, film) && command.find("--width") == std::string::npos;
    const std::string program = "'" + std::string(IMPULSE_BINARY) + "'";
    std::string size = " --size 160x90";
    if (fs::exists(shownBelow(command)))
        size = command.starts_with("impulse strip") ? " --size 320x180" : " --size 480x270";
    return std::regex_replace(command, std::regex("^impulse"), program) + (drawn ? size : "");
}

/// The mean difference of all colours, of 255; 255 if the sizes differ.
double differenceOf(const fs::path& one, const fs::path& other) {
    const render::Image a = render::decodePng(demos::contentOf(one)),
                        b = render::decodePng(demos::contentOf(other));
    if (a.width != b.width || a.height != b.height) return 255.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
    return sum / static_cast<double>(a.pixels.size());
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
        const std::string line =
            "cd '" + folder_.path().string() + "' && { " + runnable(command) + "; } > log 2>&1";
        EXPECT_EQ(std::system(line.c_str()), 0) << command << "\n" << textOf(folder_ / "log");
        const fs::path shown = shownBelow(command);
        if (!fs::exists(shown)) return;
        ++shown_;
        EXPECT_LT(differenceOf(shown, folder_ / shown.filename()), 2.0)
            << "the page's picture is not what the command draws: copy " << folder_.path()
            << "'s to " << shown;
    }

    support::TemporaryFolder folder_;
    fs::path file_;
    int shown_ = 0;  // pictures of the page that were drawn again
};

TEST_P(Newcomers, FindThatEveryBlockWorks) {
    const bool haveChromium =
        std::system("command -v chromium || command -v chromium-browser") == 0;
    const std::vector<Block> blocks = blocksOf(textOf(demosFolder("scenes") / GetParam()));
    ASSERT_GE(blocks.size(), 10u);
    for (const Block& block : blocks) {
        if (block.language != "sh") {
            write(block);
            continue;
        }
        std::istringstream commands(block.text);
        for (std::string command; std::getline(commands, command);)
            if (haveChromium || !command.ends_with(".pptx")) run(command);
    }
    const auto pictures =
        matches(textOf(demosFolder("scenes") / GetParam()), R"(\]\((pictures/[^)]+)\))");
    EXPECT_EQ(shown_, static_cast<int>(pictures.size()));
}

/// They are in the repository, in the package and in the program.
TEST(NewcomersPages, HaveSmallPictures) {
    std::uintmax_t bytes = 0;
    for (const auto& file : fs::directory_iterator(demosFolder("scenes") / "pictures"))
        bytes += file.file_size();
    EXPECT_GT(bytes, 100'000u);
    EXPECT_LT(bytes, 300'000u);
}

INSTANTIATE_TEST_SUITE_P(Pages, Newcomers, testing::Values("first-scene.md", "recipes.md"),
                         [](const auto& page) {
                             return std::string(page.param) == "recipes.md" ? "Recipes"
                                                                            : "FirstScene";
                         });

}  // namespace
