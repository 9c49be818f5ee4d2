/// Names with stars: "box*" is every name that begins with box.
#pragma once
#include <string_view>

namespace demos {

/// `*` matches any characters, also none.
bool matches(std::string_view pattern, std::string_view name);

/// Whether one pattern of a comma-separated list matches: "box*,ball".
bool matchesAny(std::string_view patterns, std::string_view name);

}  // namespace demos
