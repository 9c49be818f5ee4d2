/// Finds another program.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

namespace render {

/// The path of a program of this name in PATH; nothing if there is none.
std::optional<std::filesystem::path> programPath(std::string_view name);

}  // namespace render
