#include "demos/text/rounded.h"

#include <charconv>
#include <cmath>

namespace demos {

double rounded(double value, int digits) {
    char text[32];
    if (!std::isfinite(value)) return value;
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
    double result = 0.0;  // also for values too small for a double
    std::from_chars(text, end.ptr, result);
    return result;
}

}  // namespace demos
