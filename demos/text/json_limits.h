/// Limits of JSON that is read from files.
#pragma once
#include <string>
#include <string_view>

namespace demos {

inline constexpr std::size_t kMostJsonBytes = 64u << 20;
inline constexpr int kMostJsonDepth = 64;          // nested brackets; our files have fewer than ten
inline constexpr int kMostJsonMembers = 16'384;    // of one object: they are searched linearly
inline constexpr int kMostJsonValues = 4'000'000;  // in total

/// The limit that is exceeded, "is nested deeper than 64"; empty: none. A text beyond a limit is
/// not parsed: its values would be copied and destroyed recursively, or take hours or gigabytes.
std::string jsonTrouble(std::string_view json);

/// Throws std::invalid_argument if a limit is exceeded.
void checkJson(std::string_view json);

}  // namespace demos
