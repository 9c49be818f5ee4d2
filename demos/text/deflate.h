/// Compresses bytes for files in a repository and for pages.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace demos {

/// The bytes as a zlib stream (RFC 1950). Throws std::bad_alloc.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes);

/// The reverse; nothing if the stream is damaged or has more than `most` bytes.
std::optional<std::vector<std::uint8_t>> inflated(std::span<const std::uint8_t> bytes,
                                                  std::size_t most);

}  // namespace demos
