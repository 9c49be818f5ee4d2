#include "demos/text/json_limits.h"

#include <array>
#include <stdexcept>

namespace demos {
namespace {

std::string beyond(const char* what, std::size_t limit) { return what + std::to_string(limit); }

/// The end of a string that begins at `i`.
std::size_t endOfString(std::string_view json, std::size_t i) {
    for (++i; i < json.size() && json[i] != '"'; ++i)
        if (json[i] == '\\') ++i;
    return i;
}

}  // namespace

std::string jsonTrouble(std::string_view json, const JsonLimits& limits) {
    if (json.size() > limits.bytes) return beyond("has more bytes than ", limits.bytes);
    std::array<int, kMostJsonDepth + 1> members{};  // of the open objects, by depth
    int depth = 0, values = 0;
    long search = 0;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') i = endOfString(json, i);
        if ((c == '[' || c == '{') && ++depth > kMostJsonDepth)
            return beyond("is nested deeper than ", kMostJsonDepth);
        if (c == '[' || c == '{') members[static_cast<std::size_t>(depth)] = 0;
        if ((c == ']' || c == '}') && depth > 0) --depth;
        if (c == ':' && ++members[static_cast<std::size_t>(depth)] > kMostJsonMembers)
            return beyond("has an object with more members than ", kMostJsonMembers);
        if (c == ':' && (search += members[static_cast<std::size_t>(depth)]) > kMostJsonSearch)
            return "has too many objects with thousands of members";
        if ((c == ',' || c == '[' || c == '{') && ++values > limits.values)
            return beyond("has more values than ", static_cast<std::size_t>(limits.values));
    }
    return {};
}

void checkJson(std::string_view json, const JsonLimits& limits) {
    const std::string trouble = jsonTrouble(json, limits);
    if (!trouble.empty()) throw std::invalid_argument(trouble);
}

}  // namespace demos
