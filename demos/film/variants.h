/// One scene under several settings, for compare and sweep.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/film/frame_choice.h"
#include "demos/options/options.h"
#include "demos/scene/description.h"

namespace demos {

struct Variant {
    std::string label;                  // for captions and tables
    std::vector<std::string> settings;  // as --set takes them
    SceneDescription scene;
};

/// "solver.nudges=0,4" -> key and values; commas within brackets or quotes do not separate.
struct Variation {
    std::string key;
    std::vector<std::string> values;
};
/// Throws Stop (usage); `option` is named in the message.
Variation variationFrom(const std::string& text, const std::string& option);

/// --over takes lists, and ranges: "1..64" every whole number, "1..64:x2" doubling, "0..1:0.25" in
/// steps. Throws Stop (usage).
Variation rangeFrom(const std::string& text, const std::string& option);

/// All combinations, the last variation changing fastest.
std::vector<std::vector<std::string>> combinations(const std::vector<Variation>& variations);

/// Reads the scene once for each variant. Throws SceneError, which names `option` if a setting is
/// wrong. An empty label becomes the settings that not all variants share. `shard`: only its variants
/// and the first have a scene.
std::vector<Variant> variantsOf(const Options& options,
                                const std::vector<std::vector<std::string>>& settings,
                                const std::vector<std::string>& labels, const std::string& option,
                                const std::optional<Shard>& shard = std::nullopt);

/// "nudges=0, slop=0.01": the settings that not all variants share; may be empty.
std::string differencesOf(const std::vector<Variant>& variants, std::size_t number);

}  // namespace demos
