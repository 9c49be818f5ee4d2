/// Limits of JSON that is read from files.
#pragma once
#include <string>
#include <string_view>

namespace demos {

inline constexpr int kMostJsonDepth = 64;       // nested brackets; our files have fewer than ten
inline constexpr int kMostJsonMembers = 16'384;  // of one object: they are searched linearly,
inline constexpr long kMostJsonSearch = 200'000'000;  // in all objects: sum of members^2 / 2

/// What a reader needs at most: a value may take 100 bytes of memory.
struct JsonLimits {
    std::size_t bytes;
    int values;  // in total
};

inline constexpr JsonLimits kRunJson{64u << 20, 4'000'000};     // run.json: a million frames
inline constexpr JsonLimits kGltfJson{64u << 20, 1'000'000};    // the text of a glTF file
inline constexpr JsonLimits kReportJson{64u << 20, 1'000'000};  // report.json: a thousand scenes
inline constexpr JsonLimits kBaselineJson{64u << 20, 100'000};  // baseline.json: mostly one text
inline constexpr JsonLimits kGalleryJson{4u << 20, 100'000};    // gallery.json: a thousand scenes
inline constexpr JsonLimits kSectionsJson{16u << 20, 100'000};  // sections.json: 200 slides
inline constexpr JsonLimits kPassedJson{1u << 20, 50'000};      // passed.json: a thousand scenes
inline constexpr JsonLimits kBenchJson{1u << 20, 50'000};       // lines of impulse bench --json

/// The limit that is exceeded, "is nested deeper than 64"; empty: none. A text beyond a limit is
/// not parsed: its values would be copied and destroyed recursively, or take hours or gigabytes.
std::string jsonTrouble(std::string_view json, const JsonLimits& limits);

/// Throws std::invalid_argument if a limit is exceeded.
void checkJson(std::string_view json, const JsonLimits& limits);

}  // namespace demos
