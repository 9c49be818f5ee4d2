/// Reads texts of the repository and of the program, and searches them.
#pragma once
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace docs {

namespace fs = std::filesystem;

inline std::string textOf(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A folder of demos/.
inline fs::path demosFolder(const std::string& name) {
    return fs::path(IMPULSE_SOURCE_DIR) / "demos" / name;
}

inline std::string readmeOf(const fs::path& folder) { return textOf(folder / "README.md"); }

/// What the program writes to both streams.
inline std::string outputOf(const std::string& arguments) {
    FILE* pipe = popen((std::string(IMPULSE_BINARY) + " " + arguments + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 4096> piece;
    while (const std::size_t n = std::fread(piece.data(), 1, piece.size(), pipe))
        text.append(piece.data(), n);
    pclose(pipe);
    return text;
}

/// All matches of the pattern's first group.
inline std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    std::set<std::string> result;
    const std::regex expression(pattern);
    for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
        result.insert((*i)[1]);
    return result;
}

/// A README's section from the heading to the next one; empty if there is none.
inline std::string sectionOf(const std::string& text, const std::string& heading) {
    const std::size_t begin = text.find("\n## " + heading + "\n");
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

/// The text in backquotes in the first cell of every row.
inline std::set<std::string> firstCells(const std::string& text) {
    std::set<std::string> names;
    for (const std::string& cell : matches(text, R"(\n\| (`[^|]+) \|)"))
        names.merge(matches(cell, "`([^`]+)`"));
    return names;
}

}  // namespace docs
