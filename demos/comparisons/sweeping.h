/// The runs of `impulse sweep`.
#pragma once
#include <string>
#include <vector>

#include "demos/comparisons/runs_options.h"
#include "demos/film/variants.h"

namespace demos {

struct SweepOptions : RunsOptions {
    std::string over;  // KEY=FROM..TO
    std::string csv;   // a file or "-"; empty = none
};

struct Sweeping {
    std::string key;                // the setting that changes
    std::vector<Variant> variants;  // one per value
};

/// options.over; with --shard, only its runs and the first have a scene, unless it is a --dry-run.
/// Throws Stop (usage), SceneError.
Sweeping sweepingOf(const SweepOptions& options);

/// At most 16 of them, evenly spread, with the first and the last.
std::vector<Variant> spread(const std::vector<Variant>& variants);

}  // namespace demos
