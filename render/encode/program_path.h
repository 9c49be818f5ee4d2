/// Whether another program is there.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

namespace render {

/// Where PATH has a program of this name; nothing where it has none.
std::optional<std::filesystem::path> programPath(std::string_view name);

}  // namespace render
