// Arrows point one way: what each folder may include of the project and of other libraries.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

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
        if (i.file == "engine/base/check.cpp") continue;  // the caller's bug is printed
        EXPECT_FALSE(forbidden.count(i.header)) << i.file << ": " << i.line;
    }
}

TEST(Layering, FoldersOfTheEngineLookDownOnly) {
    const std::map<std::string, std::vector<std::string>> forbidden{
        {"engine/base",
         {"engine/shapes/", "engine/dynamics/", "engine/forces/", "engine/collision/",
          "engine/constraints/", "engine/solver/", "engine/wide/", "engine/world"}},
        {"engine/shapes",
         {"engine/dynamics/", "engine/forces/", "engine/collision/", "engine/constraints/",
          "engine/solver/", "engine/wide/", "engine/world"}},
        {"engine/dynamics",
         {"engine/forces/", "engine/collision/", "engine/constraints/", "engine/solver/",
          "engine/wide/", "engine/world"}},
        {"engine/forces",
         {"engine/collision/", "engine/constraints/", "engine/solver/", "engine/wide/",
          "engine/world"}},
        {"engine/constraints",
         {"engine/collision/", "engine/solver/", "engine/wide/", "engine/world"}},
        {"engine/wide", {"engine/collision/", "engine/solver/", "engine/world"}},
        {"engine/solver", {"engine/collision/", "engine/world"}},
        {"engine/collision", {"engine/solver/", "engine/wide/", "engine/world"}}};
    for (const auto& [folder, above] : forbidden)
        for (const Include& i : includesOf(folder))
            for (const std::string& name : above)
                EXPECT_FALSE(startsWith(i.header, name)) << i.file << ": " << i.line;
}

TEST(Layering, RenderKnowsNoPhysics) {
    for (const Include& i : includesOf("render"))
        EXPECT_FALSE(startsWith(i.header, "engine/") || startsWith(i.header, "demos/"))
            << i.file << ": " << i.line;
}

/// Two types of one name in one namespace link without a word and crash: the One Definition Rule.
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
         {"demos/mjcf/xml_tree.cpp", "demos/regression/junit.cpp",
          "demos/slides/math_operators.h", "demos/slides/mathml.cpp"}},
        {"duktape.h", {"demos/slides/formula.cpp"}},
        {"cmark.h", {"demos/slides/markup_tree.h"}},
        {"CLI/CLI.hpp", {"demos/options_commands.h"}},
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
