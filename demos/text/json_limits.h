/// How much JSON is read from a file.
#pragma once
#include <string>
#include <string_view>

namespace demos {

inline constexpr std::size_t kMostJsonBytes = 64u << 20;
inline constexpr int kMostJsonDepth = 64;          // brackets in each other; our own have under ten
inline constexpr int kMostJsonMembers = 16'384;    // of one object: they are searched one by one
inline constexpr int kMostJsonValues = 4'000'000;  // in all

/// What goes beyond these limits, "is nested deeper than 64"; empty: nothing does. Such a text is
/// not parsed: its values would be copied and destroyed recursively, or take hours or gigabytes.
std::string jsonTrouble(std::string_view json);

/// Throws std::invalid_argument where something does.
void checkJson(std::string_view json);

}  // namespace demos
