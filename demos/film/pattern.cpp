#include "demos/film/pattern.h"

#include <fmt/format.h>

#include <vector>

#include "demos/text/complaints.h"
#include "demos/text/nearest.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

constexpr int kWidest = 12;  // digits

std::string padded(const std::string& pattern, int frame, std::size_t width) {
    if (width > kWidest)
        refuseOutput(pattern, fmt::format("a frame has at most {} digits", kWidest));
    return fmt::format("{:0{}}", frame, width);
}

/// The text for `{frame:6}` and the like; `word`: without the braces.
std::string hole(const std::string& pattern, const std::string& word, const PatternValues& values) {
    const std::size_t colon = word.find(':');
    const std::string name = word.substr(0, colon);
    const std::string width = colon == std::string::npos ? "" : word.substr(colon + 1);
    if (name == "frame" && colon != std::string::npos) {
        if (width.empty() || width.size() > 2 ||
            width.find_first_not_of("0123456789") != std::string::npos || std::stoi(width) < 1)
            refuseOutput(pattern,
                         fmt::format("'{{{}}}' needs a number of digits, as in {{frame:6}}",
                                     printable(word)));
        return padded(pattern, values.frame, static_cast<std::size_t>(std::stoi(width)));
    }
    if (colon == std::string::npos) {
        if (name == "frame") return fmt::format("{}", values.frame);
        if (name == "time") return fmt::format("{:.3f}", values.time);
        if (name == "scene") return values.scene;
        if (name == "quality") return values.quality;
    }
    refuseOutput(pattern, fmt::format("'{{{}}}' is not known{}", printable(word),
                                      suggestion(name, {"frame", "time", "scene", "quality"})));
}

/// Where `%06d`, `%d` or `%%` at `at` ends; npos: none of these, a plain per cent sign.
std::size_t printfEnd(const std::string& pattern, std::size_t at) {
    const std::size_t end = pattern.find_first_not_of("0123456789", at + 1);
    if (end == std::string::npos) return end;
    if (pattern[end] == '%' && end == at + 1) return end + 1;
    const bool filled = end == at + 1 || (pattern[at + 1] == '0' && end > at + 2);
    return pattern[end] == 'd' && filled ? end + 1 : std::string::npos;
}

std::string printfHole(const std::string& pattern, std::size_t at, std::size_t end,
                       const PatternValues& values) {
    if (pattern[end - 1] == '%') return "%";
    if (end - at == 2) return fmt::format("{}", values.frame);
    const std::string width = pattern.substr(at + 2, end - at - 3);
    return padded(pattern, values.frame, width.size() > 2 ? 100u : std::stoul(width));
}

}  // namespace

void refuseOutput(const std::string& output, const std::string& what) {
    throw Stop(Exit::usage,
               fmt::format("--output '{}': {}", printable(shown(output, kLongestMessage)), what));
}

std::string expandPattern(const std::string& pattern, const PatternValues& values) {
    std::string name;
    for (std::size_t i = 0; i < pattern.size();) {
        const char c = pattern[i];
        if (c == '#') {
            std::size_t end = pattern.find_first_not_of('#', i);
            if (end == std::string::npos) end = pattern.size();
            name += padded(pattern, values.frame, end - i);
            i = end;
        } else if (c == '%' && printfEnd(pattern, i) != std::string::npos) {
            const std::size_t end = printfEnd(pattern, i);
            name += printfHole(pattern, i, end, values);
            i = end;
        } else if ((c == '{' || c == '}') && i + 1 < pattern.size() && pattern[i + 1] == c) {
            name += c;
            i += 2;
        } else if (c == '{') {
            const std::size_t end = pattern.find('}', i);
            if (end == std::string::npos)
                refuseOutput(pattern, "'{' is not closed; write '{{' for a brace");
            name += hole(pattern, pattern.substr(i + 1, end - i - 1), values);
            i = end + 1;
        } else if (c == '}') {
            refuseOutput(pattern, "'}' was not opened; write '}}' for a brace");
        } else {
            name += c;
            ++i;
        }
    }
    return name;
}

bool namesEveryFrame(const std::string& pattern) {
    PatternValues a, b;
    b.frame = 1;
    b.time = 1.0;
    return expandPattern(pattern, a) != expandPattern(pattern, b);
}

}  // namespace demos
