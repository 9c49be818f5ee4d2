/// A number with its noun: "1 frame", "2 frames", "2 bodies".
#pragma once
#include <string>

namespace demos {

/// `many`: the plural, also for 0.
inline std::string plural(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// For a noun whose plural adds an s.
inline std::string plural(std::size_t count, const char* one) {
    return plural(count, one, (std::string(one) + "s").c_str());
}

}  // namespace demos
