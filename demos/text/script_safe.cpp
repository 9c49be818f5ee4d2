#include "demos/text/script_safe.h"

#include <nlohmann/json.hpp>

namespace demos {

std::string scriptSafe(const nlohmann::ordered_json& json) {
    using Json = nlohmann::ordered_json;
    std::string safe;
    for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    return safe;
}

}  // namespace demos
