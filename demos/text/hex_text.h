/// 64-bit numbers as texts: JSON's own are exact to 53 bits only.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace demos {

/// 16 digits.
std::string hexText(std::uint64_t value);
/// Back; nothing where the text is anything but a hexadecimal number of 64 bits.
std::optional<std::uint64_t> fromHex(std::string_view text);

}  // namespace demos
