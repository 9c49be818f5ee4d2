/// Reads files that this program has written.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace demos {

/// The bytes of an ordinary file, never through a symlink; empty if there is none or if it has more
/// than `most` bytes.
std::vector<std::uint8_t> contentOf(const std::filesystem::path& path,
                                    std::uintmax_t most = UINTMAX_MAX);

}  // namespace demos
