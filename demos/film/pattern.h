/// Names of output files with holes: `out/{scene}_####.png`.
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

/// `####`, `{frame:6}` and printf's `%06d`: the frame, filled up with zeros; `{frame}` and `%d`: as
/// it is; `{time}`: seconds with three decimals; `{scene}`, `{quality}`; `{{`, `}}` and `%%`: the
/// characters themselves. Any other `%` stands for itself.
/// Throws Stop (usage) for what is none of these.
std::string expandPattern(const std::string& pattern, const PatternValues& values);

/// Whether two frames get two names.
bool namesEveryFrame(const std::string& pattern);

}  // namespace demos
