/// The words that others use for the names of this program: "ball" for sphere, "pos" for at.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace demos {

/// Whether both are one word but for upper case, `_`, `-` and spaces: "lookAt" and "look_at".
bool sameLetters(std::string_view a, std::string_view b);

/// The first of the names that has the same letters, or else the same meaning; empty if there is
/// none.
std::string sameMeaning(std::string_view word, std::span<const std::string> names);

}  // namespace demos
