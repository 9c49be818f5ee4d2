/// Files of our own making, read back.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace demos {

/// An ordinary file's bytes, not through a symlink; empty when there is none, or one of more than
/// `most` bytes.
std::vector<std::uint8_t> contentOf(const std::filesystem::path& path,
                                    std::uintmax_t most = UINTMAX_MAX);

}  // namespace demos
