#include "demos/mjcf/attributes.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {

constexpr std::string_view kGaps = " \t\r\n";
constexpr std::size_t kShown = 40;  // bytes of a value in a message

bool isOrientation(std::string_view name) {
    return name == "quat" || name == "axisangle" || name == "xyaxes" || name == "zaxis" ||
           name == "euler";
}

bool isPlace(std::string_view name) {
    return isOrientation(name) || name == "pos" || name == "fromto";
}

std::optional<double> numberIn(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const char* end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string countText(std::size_t least, std::size_t most) {
    const std::string text = std::to_string(most);
    if (least == most) return text + (most == 1 ? " number" : " numbers");
    return std::to_string(least) + " to " + text + " numbers";
}

std::string rangeText(const Range& range) {
    const std::string unit = *range.unit ? std::string(" ") + range.unit : "";
    return "from " + numberText(range.low) + " to " + numberText(range.high) + unit;
}

}  // namespace

Attributes::Attributes(const Element& element, const std::vector<Attribute>& ofClass,
                       Diagnostics& diagnostics)
    : element_(element.name),
      spot_(element.spot),
      all_(element.attributes),
      diagnostics_(diagnostics) {
    const auto own = [&](auto is) {
        return std::any_of(element.attributes.begin(), element.attributes.end(),
                           [&](const Attribute& a) { return is(a.name); });
    };
    const bool turned = own(isOrientation), between = has("fromto");
    for (const Attribute& attribute : ofClass) {
        const bool beaten = (turned && isOrientation(attribute.name)) ||
                            (between && isPlace(attribute.name)) || has(attribute.name);
        if (!beaten) all_.push_back(attribute);
    }
}

const Attribute* Attributes::find(std::string_view name) const {
    for (const Attribute& attribute : all_)
        if (attribute.name == name) return &attribute;
    return nullptr;
}

Spot Attributes::spotOf(std::string_view name) const {
    const Attribute* found = find(name);
    return found ? found->spot : spot_;
}

std::string Attributes::text(std::string_view name) const {
    const Attribute* found = find(name);
    return found ? found->value : std::string();
}

std::optional<std::vector<double>> Attributes::numbers(std::string_view name, std::size_t least,
                                                       std::size_t most, Range range) {
    const Attribute* found = find(name);
    if (!found) return std::nullopt;
    std::vector<double> values;
    std::string_view rest = found->value;
    bool good = true;
    while (good) {
        rest.remove_prefix(std::min(rest.find_first_not_of(kGaps), rest.size()));
        if (rest.empty()) break;
        const std::string_view piece = rest.substr(0, rest.find_first_of(kGaps));
        rest.remove_prefix(piece.size());
        const std::optional<double> value = numberIn(piece);
        good = value && *value >= range.low && *value <= range.high && values.size() < most;
        if (good) values.push_back(*value);
    }
    if (good && values.size() >= least) return values;
    wrong(name, std::string(name) + " is '" + found->value.substr(0, kShown) + "'; it should be " +
                    countText(least, most) + " " + rangeText(range));
    return std::nullopt;
}

std::optional<double> Attributes::number(std::string_view name, Range range) {
    const auto values = numbers(name, 1, 1, range);
    return values ? std::optional(values->front()) : std::nullopt;
}

std::optional<int> Attributes::whole(std::string_view name, Range range) {
    const std::optional<double> value = number(name, range);
    if (!value) return std::nullopt;
    if (*value == std::floor(*value)) return static_cast<int>(*value);
    wrong(name, std::string(name) + " is " + numberText(*value) + "; it should be a whole number");
    return std::nullopt;
}

std::optional<Vec3> Attributes::vector(std::string_view name, Range range) {
    const auto v = numbers(name, 3, 3, range);
    return v ? std::optional(Vec3((*v)[0], (*v)[1], (*v)[2])) : std::nullopt;
}

std::optional<std::string> Attributes::word(std::string_view name,
                                            const std::vector<std::string>& words) {
    const Attribute* found = find(name);
    if (!found) return std::nullopt;
    if (std::find(words.begin(), words.end(), found->value) != words.end()) return found->value;
    wrong(name, std::string(name) + " is '" + found->value.substr(0, kShown) + "'; it should be " +
                    anyOf(words));
    return std::nullopt;
}

std::optional<bool> Attributes::truth(std::string_view name) {
    const std::optional<std::string> text = word(name, {"true", "false"});
    return text ? std::optional(*text == "true") : std::nullopt;
}

void Attributes::wrong(std::string_view name, const std::string& what) {
    diagnostics_.wrong(spotOf(name), what);
}

void Attributes::note(std::string_view name, const std::string& what) {
    diagnostics_.note(spotOf(name), what);
}

}  // namespace demos::mjcf
