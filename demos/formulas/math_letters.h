/// Bold, script, blackboard ... letters of Unicode (U+1D400 to U+1D7FF and a few older ones).
#pragma once
#include <string>
#include <string_view>

namespace demos {

/// The letters of a UTF-8 text in a variant of MathML's mathvariant ("bold", "double-struck", ...);
/// letters that the variant lacks stay as they are.
std::string inVariant(std::string_view text, std::string_view variant);

/// A bold or italic letter of inVariant() as the usual one that it stands for.
struct PlainLetter {
    char32_t letter = 0;
    bool bold = false, italic = false;
};
PlainLetter plainLetterOf(char32_t letter);

/// Adds a character as UTF-8.
void putCharacter(std::string& text, char32_t letter);

/// Removes a character from the front of valid UTF-8 and returns it.
char32_t popCharacter(std::string_view& text);

}  // namespace demos
