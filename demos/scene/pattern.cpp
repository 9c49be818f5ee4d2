#include "demos/scene/pattern.h"

namespace demos {

bool matches(std::string_view pattern, std::string_view name) {
    if (pattern.size() > kLongestPattern) return false;
    // Greedy with backtracking: on a mismatch the last star takes one more character.
    std::size_t p = 0, n = 0, star = std::string_view::npos, resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p, ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

bool matchesAny(std::string_view patterns, std::string_view name) {
    while (true) {
        const std::size_t comma = patterns.find(',');
        if (matches(patterns.substr(0, comma), name)) return true;
        if (comma == std::string_view::npos) return false;
        patterns.remove_prefix(comma + 1);
    }
}

}  // namespace demos
