/// Whole numbers in JSON from elsewhere.
#pragma once
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace demos {

/// Throws std::invalid_argument for anything but a whole number that the type holds: the library would convert
/// 1e20 to an int, which is undefined.
template <class Whole, class Json>
Whole wholeIn(const Json& json) {
    constexpr Whole kLeast = std::numeric_limits<Whole>::min(), kMost = std::numeric_limits<Whole>::max();
    const bool positive = json.is_number_unsigned();
    const bool fits = positive ? json.template get<std::uint64_t>() <= static_cast<std::uint64_t>(kMost)
                               : json.is_number_integer() && json.template get<std::int64_t>() >= kLeast &&
                                     json.template get<std::int64_t>() <= kMost;
    if (!fits) throw std::invalid_argument("no whole number in range");
    return json.template get<Whole>();
}

template <class Json, class Whole>
void wholeTo(const Json& json, Whole& to) {
    to = wholeIn<Whole>(json);
}

}  // namespace demos
