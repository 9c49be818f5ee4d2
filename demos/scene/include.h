/// include = ["parts/floor.toml"]: merges a scene file and the files it names into one document.
/// An included file is read before the including one, each file once.
///   lists of tables ([[body]], [[repeat]], ...)   one after the other
///   single tables ([world], [values], ...)        key by key, the including file's keys win
///   everything else (title, seconds, ...)         the including file wins
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/scene/toml_value.h"

namespace demos {

constexpr std::uintmax_t kMostSceneBytes = 8u << 20;  // of all files of a scene
constexpr std::size_t kDeepestInclude = 8;
constexpr std::size_t kMostSceneFiles = 64;
constexpr std::size_t kMostIncluded = 1000;  // of a list: the same file may be named again

struct Document {
    Value table;
    std::string text;  // of all files
    std::vector<std::string> files;  // that were included
};

/// `path`: the text's file, to which `include` is relative; nothing if the text is not from a file.
/// Errors name the file that they are in. Throws nothing.
Document readDocument(std::string_view text, const std::string& name,
                      const std::optional<std::filesystem::path>& path, Complaints& complaints);

}  // namespace demos
