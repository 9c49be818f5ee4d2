/// Limits of a TOML text, checked before it is parsed: the parser is recursive, and a file of dots
/// and brackets would exhaust the stack or the memory.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "demos/scene/description.h"

namespace demos {

inline constexpr int kDeepestNesting = 32;  // of tables and arrays, and parts of a key
inline constexpr int kMostTomlValues = 1'000'000;

struct BeyondLimit {
    Place place;
    std::string what;
};

/// No UTF-16, brackets 32 deep, keys of 32 parts, a million values; quoted text and comments do not
/// count. Outside of them TOML is ASCII, and toml++ 3.3 has undefined behaviour if a non-ASCII
/// character follows a value (is_non_ascii_horizontal_whitespace, found by tests/fuzz).
std::optional<BeyondLimit> beyondLimits(std::string_view text);

}  // namespace demos
