/// Bytes made small, for what is kept in a repository or in a page.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace demos {

/// As a zlib stream (RFC 1950). Throws std::bad_alloc.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes);

/// Back; nothing where that is damaged or holds more than `most` bytes.
std::optional<std::vector<std::uint8_t>> inflated(std::span<const std::uint8_t> bytes,
                                                  std::size_t most);

}  // namespace demos
