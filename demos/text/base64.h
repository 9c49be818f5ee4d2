/// Bytes as text for JSON and data: URIs. RFC 4648, section 4.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace demos {

std::string toBase64(std::span<const std::uint8_t> bytes);

/// The bytes in a string; nothing if the text is not base64.
std::optional<std::string> fromBase64(std::string_view text);

}  // namespace demos
