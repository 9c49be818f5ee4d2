#include "demos/film/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "demos/film/film_plan.h"
#include "demos/film/part_review.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

constexpr int kMostValues = 1000;

[[noreturn]] void refuseSweep(const std::string& option, const std::string& text,
                              const std::string& what) {
    throw Stop(Exit::usage, fmt::format("{} '{}': {}", option, printable(text), what));
}

/// Splits at commas that are not within brackets or quotes.
std::vector<std::string> sweptValues(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        } else if (c == ',' && depth == 0) {
            parts.emplace_back();
            continue;
        }
        parts.back() += c;
    }
    return parts;
}

std::optional<double> numberFrom(const std::string& text) {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

struct ValueRange {
    double low = 0.0, high = 0.0, step = 1.0;
    bool doubling = false;  // `step` is a factor
};

/// a..b, a..b:step, a..b:xfactor
std::optional<ValueRange> rangeOf(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return std::nullopt;
    const std::size_t colon = text.find(':', dots);
    ValueRange range;
    const auto low = numberFrom(text.substr(0, dots));
    const auto high = numberFrom(
        text.substr(dots + 2, colon == std::string::npos ? std::string::npos : colon - dots - 2));
    if (!low || !high) return std::nullopt;
    range.low = *low, range.high = *high;
    if (colon == std::string::npos) return range;
    std::string step = text.substr(colon + 1);
    range.doubling = step.starts_with('x');
    const auto by = numberFrom(range.doubling ? step.substr(1) : step);
    if (!by) return std::nullopt;
    range.step = *by;
    return range;
}

bool isWhole(double x) { return x == std::floor(x); }

std::vector<std::string> valuesIn(const ValueRange& range) {
    std::vector<std::string> values;
    for (int i = 0; i <= kMostValues; ++i) {  // by index: sums of 0.1 would add up errors
        const double value =
            range.doubling ? range.low * std::pow(range.step, i) : range.low + i * range.step;
        if (value > range.high * (1.0 + 1e-12) + 1e-12) break;
        values.push_back(fmt::format("{:.12g}", value));
    }
    return values;
}

/// The settings that not all variants share.
std::string unshared(const std::vector<std::string>& settings,
                     const std::vector<std::vector<std::string>>& all) {
    std::string label;
    for (const std::string& setting : settings) {
        const bool shared = std::all_of(all.begin(), all.end(), [&](const auto& other) {
            return std::find(other.begin(), other.end(), setting) != other.end();
        });
        if (shared && all.size() > 1) continue;
        const std::size_t dot = setting.substr(0, setting.find('=')).find_last_of('.');
        label += (label.empty() ? "" : ", ") +
                 (dot == std::string::npos ? setting : setting.substr(dot + 1));
    }
    return label;
}

std::string labelOf(const std::vector<std::string>& settings,
                    const std::vector<std::vector<std::string>>& all) {
    const std::string label = unshared(settings, all);
    return label.empty() ? "as it is" : label;
}

/// Errors name the option that was given, not --set.
SceneError asOption(const SceneError& error, const std::string& option) {
    std::vector<std::string> lines = error.lines();
    for (std::string& line : lines)
        if (line.starts_with("--set ")) line = option + line.substr(5);
    return SceneError(lines);
}

}  // namespace

Variation variationFrom(const std::string& text, const std::string& option) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        refuseSweep(option, text, "must be KEY=VALUE,VALUE..., for example solver.sweeps=1,4,16");
    return {text.substr(0, equals), sweptValues(text.substr(equals + 1))};
}

Variation rangeFrom(const std::string& text, const std::string& option) {
    Variation variation = variationFrom(text, option);
    if (variation.values.size() > 1) return variation;
    const std::string value = variation.values.front();
    const std::optional<ValueRange> range = rangeOf(value);
    if (!range)
        refuseSweep(option, text, "must be a list (1,4,16) or a range (1..64, 1..64:x2, 0..1:0.25)");
    if (range->high < range->low) refuseSweep(option, text, "a range must run upwards; swap its ends");
    const bool whole = isWhole(range->low) && isWhole(range->high);
    if (value.find(':') == std::string::npos && !whole)
        refuseSweep(option, text, "a range of fractions needs a step, as in 0..1:0.25");
    if (range->doubling ? !(range->step > 1.0 && range->low > 0.0) : !(range->step > 0.0))
        refuseSweep(option, text, "a step must be above 0; a factor above 1, with the range above 0");
    variation.values = valuesIn(*range);
    if (static_cast<int>(variation.values.size()) > kMostValues)
        refuseSweep(option, text, fmt::format("more than {} values; take larger steps", kMostValues));
    return variation;
}

std::vector<std::vector<std::string>> combinations(const std::vector<Variation>& variations) {
    std::vector<std::vector<std::string>> all(1);
    for (const Variation& variation : variations) {
        std::vector<std::vector<std::string>> longer;
        for (const std::vector<std::string>& settings : all)
            for (const std::string& value : variation.values) {
                longer.push_back(settings);
                longer.back().push_back(variation.key + "=" + value);
            }
        all = std::move(longer);
    }
    return all;
}

std::string differencesOf(const std::vector<Variant>& variants, std::size_t number) {
    std::vector<std::vector<std::string>> all;
    for (const Variant& variant : variants) all.push_back(variant.settings);
    return unshared(all[number], all);
}

std::vector<Variant> variantsOf(const Options& options,
                                const std::vector<std::vector<std::string>>& settings,
                                const std::vector<std::string>& labels, const std::string& option,
                                const std::optional<Shard>& shard) {
    sceneOf(options);  // errors of the scene itself are reported once, without a variant
    std::vector<Variant> variants;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        Options own = options;
        own.quiet = true;  // notes have been reported
        own.overrides.insert(own.overrides.end(), settings[i].begin(), settings[i].end());
        Variant variant;
        variant.settings = settings[i];
        const bool labelled = i < labels.size() && !labels[i].empty();
        variant.label = labelled ? labels[i] : labelOf(settings[i], settings);
        try {
            if (i == 0 || !shard || isIn(*shard, i)) variant.scene = sceneOf(own);
        } catch (const SceneError& error) {
            throw asOption(error, option);
        }
        variants.push_back(std::move(variant));
    }
    return variants;
}

}  // namespace demos
