/// include = ["parts/floor.toml"]: a scene file and those it names as one document. What is
/// included is read before what includes it, each file once.
///   lists of tables ([[body]], [[repeat]], ...)   one after the other
///   single tables ([world], [values], ...)        key by key, the includer's own keys win
///   everything else (title, seconds, ...)         the includer's own wins
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/scene/toml_value.h"

namespace demos {

constexpr std::uintmax_t kMostSceneBytes = 8u << 20;  // of all files of a scene

struct Document {
    Value table;
    std::string text;  // of all files
    std::vector<std::string> files;  // that were included
};

/// `path`: where the text is from, and what `include` is relative to; nothing where it is from no
/// file. Complains with the name of the file in which it is wrong; throws nothing.
Document readDocument(std::string_view text, const std::string& name,
                      const std::optional<std::filesystem::path>& path, Complaints& complaints);

}  // namespace demos
