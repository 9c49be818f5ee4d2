/// JSON that is safe inside a page's <script>, whatever its strings contain.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace demos {

/// Inside <script> only "</script" and "<!--" have a meaning in HTML. JSON has `<` in strings only,
/// where \u003c is equivalent. All characters beyond ASCII are escaped too (U+2028).
std::string scriptSafe(const nlohmann::ordered_json& json);

}  // namespace demos
