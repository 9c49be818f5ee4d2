/// 64-bit numbers as texts: JSON numbers are only exact to 53 bits.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace demos {

/// 16 digits.
std::string hexText(std::uint64_t value);
/// The reverse; nothing if the text is not a hexadecimal number of at most 64 bits.
std::optional<std::uint64_t> fromHex(std::string_view text);

}  // namespace demos
