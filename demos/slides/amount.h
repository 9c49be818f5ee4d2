/// So many of something.
#pragma once
#include <cstddef>
#include <string>

namespace demos {

/// "1 slide", "2 slides"
inline std::string amount(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace demos
