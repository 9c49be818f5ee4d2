/// What `impulse sweep` goes through.
#pragma once
#include <string>
#include <vector>

#include "demos/comparisons/runs_options.h"
#include "demos/film/variants.h"

namespace demos {

struct SweepOptions : RunsOptions {
    std::string over;  // KEY=FROM..TO
    std::string csv;   // a file or "-"; empty = not asked for
};

struct Sweeping {
    std::string key;                // the setting that changes
    std::vector<Variant> variants;  // one a value
};

/// options.over. Throws Stop (usage), SceneError.
Sweeping sweepingOf(const SweepOptions& options);

/// At most 16 of them, the first and the last among them.
std::vector<Variant> spread(const std::vector<Variant>& variants);

}  // namespace demos
