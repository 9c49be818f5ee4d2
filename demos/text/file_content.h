/// Files of our own making, read back.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace demos {

/// An ordinary file's bytes, not through a symlink; empty when there is none.
std::vector<std::uint8_t> contentOf(const std::filesystem::path& path);

}  // namespace demos
