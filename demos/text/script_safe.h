/// JSON that stays inside a page's <script>, whatever its strings say.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace demos {

/// Inside <script> only "</script" and "<!--" mean anything to HTML, and JSON has no `<` outside of
/// its strings, where \u003c says the same. All else that is not ASCII is escaped too (U+2028).
std::string scriptSafe(const nlohmann::ordered_json& json);

}  // namespace demos
