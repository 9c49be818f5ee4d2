/// Names with stars: "box*" is every name that begins with box.
#pragma once
#include <string_view>

namespace demos {

/// `*`: any letters, also none.
bool matches(std::string_view pattern, std::string_view name);

/// One of the patterns of a list with commas: "box*,ball".
bool matchesAny(std::string_view patterns, std::string_view name);

}  // namespace demos
