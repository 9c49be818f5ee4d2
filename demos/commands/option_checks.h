/// Checks of numbers and names on the command line; the messages say what is valid.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demos/options/options.h"

namespace demos {

inline constexpr double kLongest = 1e5;  // s

/// Options that are read as text first and interpreted later.
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
    bool ofSlides = false;  // only the themes of slides are allowed
};

/// Each throws Stop (usage).
void checkRange(const char* name, int value, int low, int high);
void checkName(const char* option, const std::string& word, const std::vector<std::string>& names);
void checkTime(const char* name, const std::optional<double>& time);

/// The bytes of --max-size: "8M", "1.5G", "500k", "8MB" or a plain number; K, M, G count in thousands.
std::uint64_t maxSizeFrom(const std::string& given);

/// Moves `texts` into `options` and checks the options that commands share. Throws Stop (usage).
void checkOptions(Options& options, const OptionTexts& texts);

}  // namespace demos
