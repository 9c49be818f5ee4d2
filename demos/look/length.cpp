#include "demos/look/length.h"

#include <charconv>
#include <cmath>

namespace demos {
namespace {

struct LengthUnit {
    const char* name;
    double millimetres;
};
constexpr LengthUnit kUnits[] = {
    {"", 1.0}, {"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"pt", 25.4 / 72.0}};

}  // namespace

std::optional<double> lengthFrom(const std::string& text) {
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto got = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    if (got.ec != std::errc{} || !std::isfinite(number)) return std::nullopt;
    for (const LengthUnit& unit : kUnits)
        if (std::string(got.ptr, end) == unit.name) return number * unit.millimetres;
    return std::nullopt;
}

}  // namespace demos
