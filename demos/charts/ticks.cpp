#include "demos/charts/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace demos {
namespace {

constexpr double kConstant = 1e-5;  // of the value: a smaller change would need too long tick texts

constexpr double kBeyond = 0.08;  // of the range: the farthest extension to reach a tick

double powerOfTen(int exponent) { return std::pow(10.0, exponent); }

/// 10^exponent <= value < 10^(exponent + 1), for positive values.
int exponentOf(double value) {
    const int guess = static_cast<int>(std::floor(std::log10(value)));
    return value >= powerOfTen(guess + 1) ? guess + 1 : guess;  // log10(1000) may be 2.9999...
}

/// count * mantissa * 10^exponent, so that 3 * 0.1 is 0.3.
struct Step {
    int mantissa = 1, exponent = 0;
    double size() const { return times(1.0); }
    double times(double count) const {
        const double all = count * mantissa;
        return exponent < 0 ? all / powerOfTen(-exponent) : all * powerOfTen(exponent);
    }
};

Step niceStep(double range, double most, bool whole) {
    const double least = range / std::max(most, 1.0);
    Step step{1, exponentOf(least)};
    if (whole && step.exponent < 0) return {1, 0};
    while (step.size() < least * (1.0 - 1e-9)) {
        if (step.mantissa == 5)
            step = {1, step.exponent + 1};
        else
            step.mantissa = step.mantissa == 1 ? 2 : 5;
    }
    return step;
}

/// Widens a range of values that hardly differ, and includes 0 if it is near.
void widen(double& low, double& high, Reach reach) {
    const double most = std::max(std::abs(low), std::abs(high));
    const bool same = high - low <= kConstant * most || most < 1e-290;
    if (reach == Reach::data) {
        if (same) low -= 0.5, high += 0.5;
        if (!(low < high)) low -= 0.1 * most, high += 0.1 * most;
        return;
    }
    if (low > 0.0 && (same || low < 0.6 * high)) low = 0.0;
    if (high < 0.0 && (same || high > 0.6 * low)) high = 0.0;
    if (most < 1e-290) low = 0.0, high = 1.0;
}

const char* prefixOf(int thousands) {
    constexpr const char* kPrefixes[] = {"", "k", "M", "G", "T"};
    return kPrefixes[thousands];
}

std::string superscript(int number) {
    constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number))) text += kDigits[digit - '0'];
    return text;
}

/// With as many decimals as the step has, and a typographic minus sign.
std::string fixedText(double value, double step) {
    const int decimals = std::clamp(-exponentOf(step), 0, 12);
    return (value < 0.0 ? "−" : "") + fmt::format("{:.{}f}", std::abs(value), decimals);
}

}  // namespace

double Axis::share(double value) const {
    if (log) return std::log10(value / low) / std::log10(high / low);
    return (value - low) / (high - low);
}

Axis linearAxis(double low, double high, double most, Reach reach, bool whole) {
    widen(low, high, reach);
    const Step step = niceStep(high - low, most, whole);
    const double slack = 1e-9 * (high - low);  // 6.9999999999 s is the tick at 7
    const double first = std::floor((low + slack) / step.size());
    const double last = std::ceil((high - slack) / step.size());
    const double beyond = reach == Reach::ticks ? kBeyond * (high - low) : 0.0;
    Axis axis;
    axis.low = std::max(step.times(first), low - beyond);
    axis.high = std::min(step.times(last), high + beyond);
    const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
    for (double i = first; i <= last && axis.ticks.size() < 1000; ++i) {
        const double tick = step.times(i);
        if (tick < axis.low - slack || tick > axis.high + slack) continue;
        axis.ticks.push_back(tick);
        axis.texts.push_back(tickText(tick, step.size(), largest));
    }
    return axis;
}

Axis logAxis(double low, double high, int most) {
    int first = exponentOf(low), last = exponentOf(high);
    if (high > powerOfTen(last)) ++last;
    if (first == last) --first, ++last;
    int every = 1;
    for (const int stride : {1, 2, 3, 5, 10, 20, 50, 100, 200})
        if (every = stride; (last - first) / stride <= most) break;
    Axis axis;
    axis.low = powerOfTen(first), axis.high = powerOfTen(last);
    axis.log = true;
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % every != 0) continue;
        axis.ticks.push_back(powerOfTen(exponent));
        axis.texts.push_back(decadeText(exponent));
    }
    return axis;
}

std::string tickText(double value, double step, double largest) {
    if (value == 0.0) return "0";
    const int exponent = exponentOf(largest);
    if (exponent >= -3 && exponent < 4) return fixedText(value, step);
    if (exponent >= 4 && exponent < 15) {
        const double unit = powerOfTen(exponent / 3 * 3);
        return fixedText(value / unit, step / unit) + prefixOf(exponent / 3);
    }
    const double unit = powerOfTen(exponent);
    return fixedText(value / unit, step / unit) + "×10" + superscript(exponent);
}

std::string decadeText(int exponent) {
    if (exponent == 0) return "1";
    return exponent == 1 ? "10" : "10" + superscript(exponent);
}

}  // namespace demos
