#include "demos/text/shell_word.h"

#include <string_view>

namespace demos {

namespace {

constexpr std::string_view kPlain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";

}  // namespace

std::string shellWord(const std::string& word) {
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

bool arePlainWords(const std::string& text) {
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == ' ' || kPlain.find(c) != std::string_view::npos) continue;
        if (c == '\\' && text.substr(at, 2) == "\\'")
            ++at;
        else if (c != '\'' || (at = text.find('\'', at + 1)) == std::string::npos)
            return false;
    }
    return true;
}

}  // namespace demos
