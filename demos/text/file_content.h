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

/// Its first bytes, up to `most`.
std::vector<std::uint8_t> startOf(const std::filesystem::path& path, std::size_t most);

/// The hash of an ordinary file, in little memory; 0 if there is none, if it is empty, or has more than `most` bytes.
std::uint64_t hashOfFile(const std::filesystem::path& path,
                         std::uintmax_t most = std::uintmax_t{64} << 30);

}  // namespace demos
