// Dependencies point one way: what each folder may include of the project and of other libraries.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file, line, header;
};

std::vector<Include> includesOf(const std::string& folder) {
    std::vector<Include> result;
    const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(IMPULSE_SOURCE_DIR) / folder)) {
        const std::string ending = entry.path().extension();
        if (ending != ".h" && ending != ".cpp" && ending != ".in") continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);)
            if (std::regex_search(line, match, pattern))
                result.push_back({fs::relative(entry.path(), IMPULSE_SOURCE_DIR), line, match[1]});
    }
    return result;
}

bool startsWith(const std::string& text, const std::string& beginning) {
    return text.rfind(beginning, 0) == 0;
}

TEST(Layering, EngineIncludesEigenQhullAndItselfOnly) {
    const std::vector<Include> includes = includesOf("engine");
    EXPECT_GT(includes.size(), 100u);
    for (const Include& i : includes) {
        const bool standard =
            i.header.find('/') == std::string::npos && i.header.find('.') == std::string::npos;
        const bool intrinsics = i.header == "immintrin.h" && (i.file == "engine/base/lanes.h" ||
                                                              i.file == "engine/base/workers.cpp");
        const bool hulls =
            i.header == "libqhull_r/qhull_ra.h" && i.file == "engine/shapes/hull.cpp";
        EXPECT_TRUE(standard || intrinsics || hulls || startsWith(i.header, "Eigen/") ||
                    startsWith(i.header, "engine/"))
            << i.file << ": " << i.line;
    }
}

TEST(Layering, EngineOpensNoFileAndPrintsNothing) {
    const std::set<std::string> forbidden{"fstream",       "iostream",      "filesystem",
                                          "cstdlib",       "cstdio",        "random",
                                          "unordered_map", "unordered_set", "thread"};
    for (const Include& i : includesOf("engine")) {
        if (i.file == "engine/base/workers.cpp" && i.header == "thread") continue;
        if (i.file == "engine/base/check.cpp") continue;  // prints the caller's error
        EXPECT_FALSE(forbidden.count(i.header)) << i.file << ": " << i.line;
    }
}

using Floors = std::map<std::string, int>;  // by folder; 0 is the lowest

std::string textOf(const fs::path& path) {
    std::ifstream file(fs::path(IMPULSE_SOURCE_DIR) / path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// `lines`: from the lowest to the highest, folders with spaces between them.
Floors floorsIn(const std::vector<std::string>& lines) {
    Floors floors;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::istringstream words(lines[i]);
        for (std::string folder; words >> folder;) floors[folder] = static_cast<int>(i);
    }
    return floors;
}

/// The block ```floors of a README, the highest first.
Floors drawnFloors(const std::string& root) {
    const std::string text = textOf(root + "/README.md"), begin = "```floors\n";
    const std::size_t at = text.find(begin);
    if (at == std::string::npos) return {};
    std::istringstream drawing(
        text.substr(at + begin.size(), text.find("```", at + 3) - at - begin.size()));
    std::vector<std::string> lines;
    for (std::string line; std::getline(drawing, line);) lines.insert(lines.begin(), line);
    return floorsIn(lines);
}

/// "engine/world_state.cpp" belongs to "world", which has no folder; "engine/body.h" to ".".
std::string folderOf(const std::string& file, const std::string& root, const Floors& floors) {
    const std::string rest = file.substr(root.size() + 1);
    if (const std::size_t slash = rest.find('/'); slash != std::string::npos)
        return rest.substr(0, slash);
    for (const auto& [folder, floor] : floors)
        if (startsWith(rest, folder) && !fs::exists(fs::path(IMPULSE_SOURCE_DIR) / root / folder))
            return folder;
    return ".";
}

class LayeringOf : public testing::TestWithParam<const char*> {};

TEST_P(LayeringOf, FoldersIncludeLowerFloorsOnly) {
    const std::string root = GetParam();
    const Floors floors = drawnFloors(root);
    ASSERT_GT(floors.size(), 1u);
    std::set<std::string> seen;
    for (const Include& i : includesOf(root)) {
        if (startsWith(i.file, "demos/examples/")) continue;
        const std::string from = folderOf(i.file, root, floors);
        ASSERT_TRUE(floors.count(from)) << i.file << " belongs to no folder in the drawing";
        seen.insert(from);
        if (!startsWith(i.header, root + "/")) continue;
        const std::string to = folderOf(i.header, root, floors);
        ASSERT_TRUE(floors.count(to)) << i.file << ": " << i.line;
        EXPECT_TRUE(from == to || floors.at(to) < floors.at(from)) << i.file << ": " << i.line;
    }
    for (const auto& [folder, floor] : floors)
        EXPECT_TRUE(seen.count(folder)) << folder << " is in the drawing but has no files";
}
INSTANTIATE_TEST_SUITE_P(Roots, LayeringOf, testing::Values("engine", "render", "demos"),
                         [](const auto& root) { return std::string(root.param); });

/// A library of demos is linked to the floors below it: CMake must have the same floors.
TEST(Layering, TheFloorsOfDemosAreThoseOfItsLibraries) {
    const std::string text = textOf("demos/CMakeLists.txt");
    const std::regex floor(R"(\nimpulse_floor\(([^)]*)\))");
    std::vector<std::string> lines;
    for (std::sregex_iterator match(text.begin(), text.end(), floor), end; match != end; ++match)
        lines.push_back(std::regex_replace((*match)[1].str(), std::regex(R"([${}])"), ""));
    EXPECT_EQ(floorsIn(lines), drawnFloors("demos"));
}

TEST(Layering, EveryFileOfDemosIsInAFolder) {
    const std::set<std::string> above{"CMakeLists.txt", "README.md", "run"};
    for (const auto& entry : fs::directory_iterator(fs::path(IMPULSE_SOURCE_DIR) / "demos"))
        EXPECT_TRUE(entry.is_directory() || above.contains(entry.path().filename())) << entry.path();
}

/// Formulas, slides, the site and models can be left out of the program (IMPULSE_SLIDES, IMPULSE_MJCF).
TEST(Layering, WhatMayBeLeftOutIsIncludedUnderItsMacroOnly) {
    const std::regex include(R"(^#include "demos/(formulas|slides|site|mjcf)/)"), macro(R"(^#ifdef (\w+))"),
        itself("^demos/(formulas|slides|site|mjcf)/");
    int includes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(IMPULSE_SOURCE_DIR) / "demos")) {
        const std::string path = fs::relative(entry.path(), IMPULSE_SOURCE_DIR);
        if (entry.is_directory() || std::regex_search(path, itself)) continue;
        std::ifstream file(entry.path());
        std::smatch match;
        std::string under;
        for (std::string line; std::getline(file, line);) {
            if (std::regex_search(line, match, macro)) under = match[1];
            if (startsWith(line, "#e")) under.clear();  // #else, #endif
            if (!std::regex_search(line, match, include)) continue;
            EXPECT_EQ(under, match[1] == "mjcf" ? "IMPULSE_HAVE_MJCF" : "IMPULSE_HAVE_SLIDES")
                << path << ": " << line;
            ++includes;
        }
    }
    EXPECT_GT(includes, 5);
}

/// The lines of a fenced block of a README.
std::vector<std::string> blockOf(const std::string& readme, const std::string& name) {
    const std::string text = textOf(readme), begin = "```" + name + "\n";
    const std::size_t at = text.find(begin);
    if (at == std::string::npos) return {};
    const std::size_t first = at + begin.size();
    std::istringstream block(text.substr(first, text.find("```", first) - first));
    std::vector<std::string> lines;
    for (std::string line; std::getline(block, line);) lines.push_back(line);
    return lines;
}

/// True if the function begins at the left edge: that is its definition, not a call.
bool defines(const std::string& file, const std::string& function) {
    return std::regex_search(textOf(file), std::regex("\n\\w[^\n;]*\\b" + function + "\\("));
}

// The comments in World::step and the tables of the README name the file that has the function.
TEST(Signposts, OfTheStepPointToTheFunctions) {
    const std::string text = textOf("engine/world.cpp"), begin = "bool World::step(";
    const std::size_t at = text.find(begin);
    ASSERT_NE(at, std::string::npos);
    const std::string step = text.substr(at, text.find("\n}\n", at) - at);
    const std::regex post(R"((\w+)\([^\n]*;  // ([a-z_/]+\.cpp))");
    int posts = 0;
    for (std::sregex_iterator match(step.begin(), step.end(), post), end; match != end; ++match) {
        EXPECT_TRUE(defines("engine/" + (*match)[2].str(), (*match)[1])) << match->str();
        ++posts;
    }
    EXPECT_GE(posts, 7);
    const std::regex row(R"(^(\w+) .* ([a-z_]+/[a-z_]+\.cpp))");
    const std::vector<std::string> rows = blockOf("engine/README.md", "steps");
    EXPECT_EQ(rows.size(), 6u);
    for (const std::string& line : rows) {
        std::smatch match;
        ASSERT_TRUE(std::regex_search(line, match, row)) << line;
        EXPECT_TRUE(defines("engine/" + match[2].str(), match[1])) << line;
    }
}

TEST(Signposts, FromTheStepToTheArithmeticItIsThreeCalls) {
    const std::vector<std::string> hops = blockOf("engine/README.md", "hops");
    ASSERT_EQ(hops.size(), 4u);
    std::string above;
    for (const std::string& line : hops) {
        std::istringstream words(line);
        std::string function, file;
        words >> function >> file;
        EXPECT_TRUE(defines("engine/" + file, "(?:\\w+::)?" + function)) << line;
        const bool called =
            above.empty() ||
            std::regex_search(textOf(above), std::regex("[ .>]" + function + "\\("));
        EXPECT_TRUE(called) << above << " does not call " << function;
        above = "engine/" + file;
    }
}

TEST(Layering, TheTopLevelIsAsItsOwnerHasFixedIt) {
    const std::set<std::string> fixed{"CMakeLists.txt", "engine", "render",   "demos",
                                      "tests",          "output", "README.md"};
    for (const auto& entry : fs::directory_iterator(IMPULSE_SOURCE_DIR)) {
        const std::string name = entry.path().filename();
        EXPECT_TRUE(startsWith(name, ".") || startsWith(name, "build") || fixed.contains(name)) << name;
    }
}

TEST(Layering, RenderKnowsNoPhysics) {
    for (const Include& i : includesOf("render"))
        EXPECT_FALSE(startsWith(i.header, "engine/") || startsWith(i.header, "demos/"))
            << i.file << ": " << i.line;
}

/// Two types of the same name in one namespace violate the One Definition Rule: they link silently
/// and crash.
TEST(Layering, EveryTypeOfAFolderHasItsOwnName) {
    const std::regex definition(R"(^(?:struct|class) (?:alignas\(\d+\) )?(\w+)[^;]*\{)");
    for (const char* folder : {"engine", "render", "demos"}) {
        std::map<std::string, std::string> where;
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(IMPULSE_SOURCE_DIR) / folder)) {
            if (entry.path().extension() != ".h") continue;
            std::ifstream file(entry.path());
            std::smatch match;
            for (std::string line; std::getline(file, line);)
                if (std::regex_search(line, match, definition)) {
                    const bool added = where.emplace(match[1], entry.path().string()).second;
                    EXPECT_TRUE(added)
                        << match[1] << ": " << entry.path() << " and " << where[match[1]];
                }
        }
        EXPECT_GT(where.size(), 10u);
    }
}

TEST(Layering, EachOfTheseLibrariesHasItsFiles) {
    const std::map<std::string, std::set<std::string>> only{
        {"libqhull_r/qhull_ra.h", {"engine/shapes/hull.cpp"}},
        {"GL/osmesa.h", {"render/context_osmesa.cpp"}},
        {"EGL/egl.h", {"render/context_egl.cpp"}},
        {"stb/stb_image_write.h", {"render/encode/png.cpp"}},
        {"stb/stb_truetype.h", {"render/glyphs.cpp"}},
        {"tiny_obj_loader.h", {"demos/scene/obj_file.cpp"}},
        {"pugixml.hpp",
         {"demos/mjcf/xml_tree.cpp", "demos/formulas/mathml_elements.h",
          "demos/formulas/math_operators.h", "demos/formulas/mathml.cpp"}},
        {"duktape.h", {"demos/formulas/formula.cpp"}},
        {"cmark.h", {"demos/slides/markup_tree.h"}},
        {"CLI/CLI.hpp",
         {"demos/commands/no_slides.cpp", "demos/commands/shared_options.h",
          "demos/program/parse.cpp"}},
        {"muParserBase.h", {"demos/scene/expression.cpp"}}};
    std::map<std::string, std::set<std::string>> seen;
    for (const char* folder : {"engine", "render", "demos"})
        for (const Include& i : includesOf(folder)) {
            const auto found = only.find(i.header);
            if (found == only.end()) continue;
            EXPECT_TRUE(found->second.count(i.file)) << i.file << ": " << i.line;
            seen[i.header].insert(i.file);
        }
    EXPECT_EQ(seen, only);
}

}  // namespace
