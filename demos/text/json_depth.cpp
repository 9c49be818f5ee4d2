#include "demos/text/json_depth.h"

#include <stdexcept>
#include <string>

namespace demos {

bool isTooDeep(std::string_view json) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (quoted && c == '\\') ++i;
        else if (c == '"') quoted = !quoted;
        else if (!quoted && (c == '[' || c == '{') && ++depth > kMostJsonDepth) return true;
        else if (!quoted && (c == ']' || c == '}')) --depth;
    }
    return false;
}

void checkDepth(std::string_view json) {
    if (isTooDeep(json))
        throw std::invalid_argument("is nested deeper than " + std::to_string(kMostJsonDepth));
}

}  // namespace demos
