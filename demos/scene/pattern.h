/// Names with stars: "box*" is every name that begins with box.
#pragma once
#include <cstddef>
#include <string_view>

namespace demos {

inline constexpr std::size_t kLongestPattern = 200;  // bytes; a name has at most 64
inline constexpr std::size_t kMostPatterns = 100;    // of a list in a scene

/// A pattern of more than 200 bytes matches nothing. `*` matches any characters, also none.
bool matches(std::string_view pattern, std::string_view name);

/// Whether one pattern of a comma-separated list matches: "box*,ball".
bool matchesAny(std::string_view patterns, std::string_view name);

}  // namespace demos
