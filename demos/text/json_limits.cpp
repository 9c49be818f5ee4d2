#include "demos/text/json_limits.h"

#include <array>
#include <stdexcept>

namespace demos {
namespace {

std::string beyond(const char* what, long limit) { return what + std::to_string(limit); }

/// The end of a string that begins at `i`.
std::size_t endOfString(std::string_view json, std::size_t i) {
    for (++i; i < json.size() && json[i] != '"'; ++i)
        if (json[i] == '\\') ++i;
    return i;
}

}  // namespace

std::string jsonTrouble(std::string_view json) {
    if (json.size() > kMostJsonBytes) return beyond("has more bytes than ", kMostJsonBytes);
    std::array<int, kMostJsonDepth + 1> members{};  // of the open objects, by depth
    int depth = 0, values = 0;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') i = endOfString(json, i);
        if ((c == '[' || c == '{') && ++depth > kMostJsonDepth)
            return beyond("is nested deeper than ", kMostJsonDepth);
        if (c == '[' || c == '{') members[static_cast<std::size_t>(depth)] = 0;
        if ((c == ']' || c == '}') && depth > 0) --depth;
        if (c == ':' && ++members[static_cast<std::size_t>(depth)] > kMostJsonMembers)
            return beyond("has an object with more members than ", kMostJsonMembers);
        if ((c == ',' || c == '[' || c == '{') && ++values > kMostJsonValues)
            return beyond("has more values than ", kMostJsonValues);
    }
    return {};
}

void checkJson(std::string_view json) {
    const std::string trouble = jsonTrouble(json);
    if (!trouble.empty()) throw std::invalid_argument(trouble);
}

}  // namespace demos
