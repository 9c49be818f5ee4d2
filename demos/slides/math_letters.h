/// Bold, script, blackboard ... letters of Unicode (U+1D400 to U+1D7FF and a few that are older).
#pragma once
#include <string>
#include <string_view>

namespace demos {

/// The letters of a UTF-8 text in a variant of MathML's mathvariant ("bold", "double-struck", ...);
/// what the variant lacks stays as it is.
std::string inVariant(std::string_view text, std::string_view variant);

/// Takes a character of valid UTF-8 off the front.
char32_t takeCharacter(std::string_view& text);

}  // namespace demos
