/// A number with its noun: "1 frame", "2 frames", "2 bodies".
#pragma once
#include <string>

namespace demos {

/// `many`: what more than one, or none, are called.
inline std::string plural(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Of a noun whose plural ends in s.
inline std::string plural(std::size_t count, const char* one) {
    return plural(count, one, (std::string(one) + "s").c_str());
}

}  // namespace demos
