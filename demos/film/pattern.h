/// Names of output files with placeholders: `out/{scene}_####.png`.
#pragma once
#include <string>

namespace demos {

struct PatternValues {
    int frame = 0;
    double time = 0.0;  // s
    std::string scene, quality;
};

/// Throws Stop (usage): `what` is wrong with this --output.
[[noreturn]] void refuseOutput(const std::string& output, const std::string& what);

/// `####`, `{frame:6}` and printf's `%06d`: the frame, padded with zeros; `{frame}` and `%d`: not
/// padded; `{time}`: seconds with three decimals; `{scene}`, `{quality}`; `{{`, `}}` and `%%`: the
/// characters themselves. Any other `%` is literal.
/// Throws Stop (usage) for other braces.
std::string expandPattern(const std::string& pattern, const PatternValues& values);

/// Whether every frame gets a name of its own.
bool namesEveryFrame(const std::string& pattern);

}  // namespace demos
