/// The options of `impulse test`.
#pragma once
#include <optional>
#include <string>

#include "demos/film/frame_choice.h"
#include "demos/options/options.h"

namespace demos {

struct TestOptions : Options {
    std::string baselines;  // a folder; empty = next to the scenes
    std::string update;     // missing, changed, all, none; empty = missing, or none where CI is set
    bool cache = true;      // skip scenes that have passed
    bool selfTest = false;
    std::optional<Shard> shard;  // a part of the scenes
    bool merge = false;          // one report from those of parts, whose folders are `scenes`
    bool dryRun = false;         // only list the scenes
    std::string summary;  // a file for Markdown; empty: none
};

}  // namespace demos
