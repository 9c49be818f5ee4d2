/// Ranges and names of the command line, with messages that say what would be right.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/options/options.h"

namespace demos {

inline constexpr double kLongest = 1e5;  // s

/// What is parsed as text first and understood later.
struct OptionTexts {
    std::string size;
    std::string maxSize;
    std::string shard;
    std::vector<std::string> times;
    std::vector<std::string> show;
    std::vector<std::string> passes;
    std::vector<std::string> what;
    std::string solver;
    std::string width;
    std::optional<int> dpi;
    bool opaque = false;  // no theme without a ground
};

/// Each throws Stop (usage).
void checkRange(const char* name, int value, int low, int high);
void checkName(const char* option, const std::string& word, const std::vector<std::string>& names);
void checkTime(const char* name, const std::optional<double>& time);

/// Moves `texts` into `options` and checks what commands share. Throws Stop (usage).
void checkOptions(Options& options, const OptionTexts& texts);

}  // namespace demos
