/// How deep JSON from a file may be nested.
#pragma once
#include <string_view>

namespace demos {

/// Brackets within brackets; what the program writes has under ten.
inline constexpr int kMostJsonDepth = 64;

/// Whether brackets outside of strings are nested deeper than that. Such a text is not parsed: its
/// values would be copied, written and destroyed recursively.
bool isTooDeep(std::string_view json);

/// Throws std::invalid_argument where it is too deep.
void checkDepth(std::string_view json);

}  // namespace demos
