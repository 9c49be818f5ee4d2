/// Ranges and names of the command line, with messages that say what would be right.
#pragma once
#include "demos/options.h"

namespace demos {

/// What is parsed as text first and understood here.
struct RawOptions {
    std::string size;
    std::string maxSize;
    std::vector<std::string> times;
    std::vector<std::string> show;
    std::vector<std::string> passes;
    std::vector<std::string> what;
    std::string solver;
    std::string width;
    std::optional<int> dpi;
};

/// Throws Stop (usage).
[[noreturn]] void refuse(const std::string& line);

/// Moves `raw` into `options`. Throws Stop (usage).
void checkOptions(Options& options, const RawOptions& raw);

}  // namespace demos
