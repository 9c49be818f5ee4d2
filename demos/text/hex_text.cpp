#include "demos/text/hex_text.h"

#include <fmt/format.h>

#include <charconv>

namespace demos {

std::string hexText(std::uint64_t value) { return fmt::format("{:016x}", value); }

std::optional<std::uint64_t> fromHex(std::string_view text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto got = std::from_chars(text.data(), end, value, 16);
    if (got.ec != std::errc{} || got.ptr != end) return std::nullopt;
    return value;
}

}  // namespace demos
