#include "demos/slides/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace demos {
namespace {

constexpr double kMostCounted = 1e15;                   // about the largest exact whole number
constexpr double kLeastPlain = 1e-3, kMostPlain = 1e9;  // written out without a prefix
constexpr double kLeastLength = 1.0, kLeastPrefixed = 0.1;  // below: the next smaller prefix
constexpr const char* kNoBreak = "\u00a0";
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

/// The divisor of a shown value.
struct Scale {
    int power = 0;  // of 1000, shown as the prefix
    int tens = 0;   // of 10, written out
    double factor() const { return std::pow(1000.0, power) * std::pow(10.0, tens); }
};

bool takesPrefix(const std::string& unit) {
    const std::array<const char*, 5> units = {"m", "m/s", "J", "N", "N s"};
    return std::find(units.begin(), units.end(), unit) != units.end();
}

/// The value rounded as it will be shown: 999.9996 with three digits is 1000.
double asShown(double value, int digits) {
    return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

/// The exponent of the first significant digit: 2 for 271.8, 0 for 3, -3 for 0.00271.
int exponentOf(double value) {
    const std::string text = fmt::format("{:.16e}", value);
    return std::atoi(text.c_str() + text.find('e') + 1);
}

Scale scaleOf(double value, const std::string& unit) {
    double size = std::abs(value);
    if (size == 0.0) return {};
    if (!takesPrefix(unit))
        return size >= kLeastPlain && size < kMostPlain ? Scale{} : Scale{0, exponentOf(value)};
    // Slightly less, for rounding in multiplications: 1e-6 m is 1 µm.
    const double least = (1.0 - 1e-12) * (unit == "m" ? kLeastLength : kLeastPrefixed);
    Scale scale;
    for (; size >= 1000.0 && scale.power < kMostPower; size /= 1000.0) ++scale.power;
    for (; size < least && scale.power > kLeastPower; size *= 1000.0) --scale.power;
    return size >= least && size < 1000.0 ? scale : Scale{0, exponentOf(value)};
}

std::string withoutZeros(std::string text) {
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// Never with an exponent; a value that rounds to zero is "0".
std::string fixedText(double value, int decimals, Zeros zeros) {
    const std::string text = fmt::format("{:.{}f}", value, std::max(decimals, 0));
    if (text.find_first_of("123456789") == std::string::npos) return "0";
    return zeros == Zeros::kept ? text : withoutZeros(text);
}

/// In a text, replaces the hyphen by a minus sign; in a formula LaTeX does that.
std::string withMinus(const std::string& number, NumberSetting setting) {
    std::string text;
    for (const char c : number)
        text += c == '-' && setting == NumberSetting::text ? "\u2212" : std::string(1, c);
    return text;
}

std::string tensText(int tens, NumberSetting setting) {
    if (tens == 0) return "";
    if (setting == NumberSetting::formula) return fmt::format(" \\times 10^{{{}}}", tens);
    constexpr std::array<const char*, 10> kRaised = {"\u2070", "\u00b9", "\u00b2", "\u00b3",
                                                     "\u2074", "\u2075", "\u2076", "\u2077",
                                                     "\u2078", "\u2079"};
    std::string text = std::string(kNoBreak) + "\u00d7" + kNoBreak + "10";
    for (const char c : std::to_string(tens))
        text += c == '-' ? "\u207b" : kRaised[static_cast<std::size_t>(c - '0')];
    return text;
}

/// The unit with upright letters and its spaces kept: N s.
std::string texOf(const std::string& unit) {
    std::string tex;
    for (const char c : unit) tex += c == ' ' ? std::string("\\,") : std::string(1, c);
    return "\\mathrm{" + tex + "}";
}

std::string withUnit(const std::string& number, const std::string& unit, Scale scale,
                     NumberSetting setting) {
    const std::string scaled = withMinus(number, setting) + tensText(scale.tens, setting);
    if (unit.empty()) return scaled;
    const Prefix& prefix = kPrefixes[static_cast<std::size_t>(scale.power - kLeastPower)];
    if (setting == NumberSetting::text) {
        std::string text = scaled + kNoBreak + prefix.text;
        for (const char c : unit) text += c == ' ' ? kNoBreak : std::string(1, c);
        return text;
    }
    if (unit == "deg") return scaled + "^\\circ";
    const std::string upright = scale.power == -2 ? "" : prefix.text;  // the Greek one is a command
    return scaled + "\\," + (upright.empty() ? prefix.tex : "") + texOf(upright + unit);
}

std::string notFiniteText(double value, NumberSetting setting) {
    const std::string word = std::isnan(value) ? "undefined"
                             : value > 0.0     ? "infinite"
                                               : "-infinite";
    return setting == NumberSetting::text ? withMinus(word, setting)
                                          : fmt::format("\\text{{{}}}", word);
}

}  // namespace

std::string quantityText(double value, const std::string& unit, int digits, NumberSetting setting,
                         Zeros zeros) {
    if (!std::isfinite(value)) return notFiniteText(value, setting);
    if (unit.empty() && value == std::floor(value) && std::abs(value) < kMostCounted)
        return withMinus(fixedText(value, 0, zeros), setting);
    const double shown = asShown(value, digits);
    if (shown == 0.0) return withUnit("0", unit, {}, setting);
    const Scale scale = scaleOf(shown, unit);
    const double part = asShown(shown / scale.factor(), digits);
    return withUnit(fixedText(part, digits - 1 - exponentOf(part), zeros), unit, scale, setting);
}

std::string vectorText(const engine::Vec3& value, const std::string& unit, int digits,
                       NumberSetting setting, Zeros zeros) {
    if (!std::isfinite(value.sum())) return notFiniteText(value.sum(), setting);
    const double shown = asShown(value.cwiseAbs().maxCoeff(), digits);
    const Scale scale = scaleOf(shown, unit);
    const double largest = asShown(shown / scale.factor(), digits);
    const int decimals = shown > 0.0 ? digits - 1 - exponentOf(largest) : 0;
    const auto part = [&](double x) { return fixedText(x / scale.factor(), decimals, zeros); };
    const char* comma = setting == NumberSetting::text ? ",\u00a0" : ", ";
    return withUnit(
        fmt::format("({1}{0}{2}{0}{3})", comma, part(value.x()), part(value.y()), part(value.z())),
        unit, scale, setting);
}

}  // namespace demos
