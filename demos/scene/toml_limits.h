/// What a text may ask of the TOML parser, checked before it is given one: a parser builds a tree
/// by recursion, and a file of dots and brackets would exhaust the stack or the memory.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "demos/scene/description.h"

namespace demos {

struct BeyondLimit {
    Place place;
    std::string what;
};

/// Brackets 32 deep, keys of 32 parts, a million values. Quoted text and comments do not count.
std::optional<BeyondLimit> beyondLimits(std::string_view text);

}  // namespace demos
