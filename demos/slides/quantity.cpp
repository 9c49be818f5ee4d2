#include "demos/slides/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace demos {
namespace {

constexpr double kMostCounted = 1e15;            // whole numbers that a double holds, about
constexpr int kLeastPower = -3, kMostPower = 3;  // of 1000: nano, giga

struct Prefix {
    const char *text, *tex;
};
constexpr std::array<Prefix, 7> kPrefixes = {{{"n", "\\mathrm{n}"},
                                              {"µ", "\\mu"},
                                              {"m", "\\mathrm{m}"},
                                              {"", ""},
                                              {"k", "\\mathrm{k}"},
                                              {"M", "\\mathrm{M}"},
                                              {"G", "\\mathrm{G}"}}};

/// A value shown as value / 1000^power.
struct Scaled {
    int power = 0;
    bool fits = true;  // false: too small for any prefix
};

bool takesPrefix(const std::string& unit) {
    const std::array<const char*, 5> units = {"m", "m/s", "J", "N", "N s"};
    return std::find(units.begin(), units.end(), unit) != units.end();
}

/// As it will be shown: 999.9996 with three digits is 1000.
double rounded(double value, int digits) {
    return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

/// Of the first significant digit: 2 of 271.8, 0 of 3, -3 of 0.00271.
int exponentOf(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

Scaled scaleOf(double value, const std::string& unit) {
    Scaled scaled;
    double size = std::abs(value);
    if (size == 0.0 || !takesPrefix(unit)) return scaled;
    for (; size >= 1000.0 && scaled.power < kMostPower; size /= 1000.0) ++scaled.power;
    for (; size < 0.1 && scaled.power > kLeastPower; size *= 1000.0) --scaled.power;
    if (size < 0.1) return {0, false};
    return scaled;
}

std::string withoutZeros(std::string text) {
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

/// Never with an exponent.
std::string fixedText(double value, int decimals) {
    return withoutZeros(fmt::format("{:.{}f}", value, std::max(decimals, 0)));
}

std::string exponentText(double value, int digits, NumberSetting setting) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const std::size_t e = text.find('e');
    const std::string mantissa = withoutZeros(text.substr(0, e));
    const int exponent = std::atoi(text.c_str() + e + 1);
    return setting == NumberSetting::formula
               ? fmt::format("{} \\times 10^{{{}}}", mantissa, exponent)
               : fmt::format("{}e{}", mantissa, exponent);
}

/// Letters upright, spaces kept: N s.
std::string texOf(const std::string& unit) {
    std::string tex;
    for (const char c : unit) tex += c == ' ' ? std::string("\\,") : std::string(1, c);
    return "\\mathrm{" + tex + "}";
}

std::string withUnit(const std::string& number, const std::string& unit, int power,
                     NumberSetting setting) {
    if (unit.empty()) return number;
    const Prefix& prefix = kPrefixes[static_cast<std::size_t>(power - kLeastPower)];
    if (setting == NumberSetting::text) return number + " " + prefix.text + unit;
    if (unit == "deg") return number + "^\\circ";
    const std::string upright = power == -2 ? "" : prefix.text;  // the Greek one is a command
    return number + "\\," + (upright.empty() ? prefix.tex : "") + texOf(upright + unit);
}

std::string notFiniteText(double value, NumberSetting setting) {
    const char* word = std::isnan(value) ? "undefined" : value > 0.0 ? "infinite" : "-infinite";
    return setting == NumberSetting::text ? word : fmt::format("\\text{{{}}}", word);
}

}  // namespace

std::string quantityText(double value, const std::string& unit, int digits, NumberSetting setting) {
    if (!std::isfinite(value)) return notFiniteText(value, setting);
    if (unit.empty() && value == std::floor(value) && std::abs(value) < kMostCounted)
        return fixedText(value, 0);
    const double shown = rounded(value, digits);
    if (shown == 0.0) return withUnit("0", unit, 0, setting);
    const Scaled scaled = scaleOf(shown, unit);
    const bool tiny = !scaled.fits || (!takesPrefix(unit) && std::abs(shown) < 1e-6);
    if (tiny) return withUnit(exponentText(shown, digits, setting), unit, 0, setting);
    const double part = rounded(shown / std::pow(1000.0, scaled.power), digits);
    return withUnit(fixedText(part, digits - 1 - exponentOf(part)), unit, scaled.power, setting);
}

std::string vectorText(const engine::Vec3& value, const std::string& unit, int digits,
                       NumberSetting setting) {
    const double largest = value.cwiseAbs().maxCoeff();
    if (!std::isfinite(value.sum())) return notFiniteText(value.sum(), setting);
    const double shown = rounded(largest, digits);
    const int power = shown > 0.0 ? scaleOf(shown, unit).power : 0;
    const double factor = std::pow(1000.0, power);
    const int decimals = shown > 0.0 ? digits - 1 - exponentOf(shown / factor) : 0;
    const auto part = [&](double x) { return fixedText(x / factor, decimals); };
    const std::string parts =
        fmt::format("({}, {}, {})", part(value.x()), part(value.y()), part(value.z()));
    return withUnit(parts, unit, power, setting);
}

}  // namespace demos
