#include "demos/scene/key_path.h"

#include <charconv>

namespace demos {

std::vector<std::string> keyParts(std::string_view path) {
    std::vector<std::string> list(1);
    bool quoted = false;
    for (const char c : path) {
        if (c == '"')
            quoted = !quoted;
        else if (c == '.' && !quoted)
            list.emplace_back();
        else if (c != ' ')
            list.back() += c;
    }
    return list;
}

std::optional<IndexedPart> indexedPart(const std::string& part) {
    const std::size_t open = part.find('[');
    if (open == std::string::npos || open == 0 || !part.ends_with(']')) return std::nullopt;
    const std::string_view inside = std::string_view(part).substr(open + 1);
    const auto index = indexNumber(inside.substr(0, inside.size() - 1));
    return index ? std::optional(IndexedPart{part.substr(0, open), *index}) : std::nullopt;
}

std::optional<std::size_t> indexNumber(std::string_view text) {
    std::size_t number = 0;
    const char* end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end) return number;
    return std::nullopt;
}

}  // namespace demos
