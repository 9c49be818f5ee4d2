#include "demos/scene/toml_mend.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "demos/text/complaints.h"

namespace demos {
namespace {

constexpr std::array kTableLists = {"body",   "joint",   "force",   "material", "repeat",
                               "section", "expect", "slide", "keys"};

std::string_view lineOf(std::string_view text, int line) {
    for (int i = 1; i < line; ++i) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find_first_of("\r\n"));
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

bool isPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; }

/// What begins here and ends before a comma, a closing bracket or a comment. A bracket that the
/// value opens does not end it: box{i}, sin(x).
std::string_view valueAt(std::string_view rest) {
    int open = 0;
    std::size_t end = 0;
    for (; end < rest.size() && rest[end] != '#'; ++end) {
        const char c = rest[end];
        if (c == '(' || c == '{' || c == '[') ++open;
        const bool closes = c == ')' || c == '}' || c == ']';
        if ((c == ',' || closes) && open == 0) break;
        if (closes) --open;
    }
    return trimmed(rest.substr(0, end));
}

/// Whether it is a value of TOML, or the key of an inline table.
bool isInOrder(std::string_view value) {
    if (value.empty() || std::string_view("\"'[{").find(value.front()) != value.npos) return true;
    if (value.find('=') != value.npos) return true;
    if (value == "true" || value == "false" || value == "inf" || value == "nan") return true;
    if (value.front() == '+') value.remove_prefix(1);
    double number = 0.0;
    const char* end = value.data() + value.size();
    const bool whole = std::from_chars(value.data(), end, number).ptr == end;
    const bool rare = value.starts_with("0x") || value.find_first_of(":_") != value.npos;
    return whole || (rare && !std::isalpha(static_cast<unsigned char>(value.front())));
}

/// The first value of the line that is no TOML; empty if there is none.
std::string_view bareValue(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote) {
            if (c == '\\' && quote == '"') ++i;
            if (c == quote) quote = 0;
            continue;
        }
        if (c == '#') break;
        if (c == '"' || c == '\'') quote = c;
        if (c != '=' && c != '[' && c != ',') continue;
        const std::string_view value = valueAt(trimmed(line.substr(i + 1)));
        if (!isInOrder(value)) return value;
    }
    return {};
}

std::string inSmallLetters(std::string_view word) {
    std::string small;
    for (const char c : word)
        small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

std::string mendOf(std::string_view value) {
    const std::string word = inSmallLetters(value);
    if (word == "true" || word == "yes" || word == "on") return "; write true";
    if (word == "false" || word == "no" || word == "off") return "; write false";
    if (value.front() == '(') return "; a list is written in brackets: [1, 2, 3]";
    const std::string quoted = "\"" + shown(value) + "\"";
    if (!std::isalpha(static_cast<unsigned char>(value.front())))
        return "; a number stands alone, without a unit; an expression is written in quotes: " +
               quoted;
    return "; texts and expressions are written in quotes: " + quoted;
}

/// Of "cannot redefine existing table 'body'".
std::string mendOfTwo(std::string_view what) {
    if (what.find("existing table") == what.npos && what.find("existing array") == what.npos)
        return "; write each key once";
    const std::size_t quote = what.find('\'');
    const std::string_view name =
        what.substr(quote + 1, what.find('\'', quote + 1) - quote - 1);
    if (std::find(kTableLists.begin(), kTableLists.end(), name) == kTableLists.end())
        return "; write [" + shown(name) + "] once";
    return "; write [[" + std::string(name) + "]] over each of them";
}

}  // namespace

std::string tomlMend(std::string_view text, int line, std::string_view what) {
    if (what.find("unknown escape sequence") != what.npos)
        return "; single quotes keep backslashes, as LaTeX needs them";
    if (what.find("redefine existing") != what.npos && what.find('\'') != what.npos)
        return mendOfTwo(what);
    constexpr std::size_t kMost = 400;  // bytes: the search takes time with their square
    const std::string_view wrong = trimmed(lineOf(text, line).substr(0, kMost));
    if (wrong.starts_with('[')) return {};
    if (const std::string_view value = bareValue(wrong); !value.empty()) return mendOf(value);
    if (what.ends_with("saw ','") && wrong.find('[') == wrong.npos)
        return "; decimals have a point: 1.5; a list is written in brackets: [1, 5]";
    const std::size_t colon = wrong.find(':');
    const std::string_view key = wrong.substr(0, colon == wrong.npos ? 0 : colon);
    const bool isKey = !key.empty() && std::all_of(key.begin(), key.end(), isPart);
    return isKey ? "; write = after a key, not :" : "";
}

}  // namespace demos
