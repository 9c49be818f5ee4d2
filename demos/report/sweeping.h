/// What `impulse sweep` goes through.
#pragma once
#include <string>
#include <vector>

#include "demos/options.h"
#include "demos/report/variants.h"

namespace demos {

struct Sweeping {
    std::string key;                // the setting that changes
    std::vector<Variant> variants;  // one a value
};

/// options.over. Throws Stop (usage), SceneError.
Sweeping sweepingOf(const Options& options);

/// At most 16 of them, the first and the last among them.
std::vector<Variant> spread(const std::vector<Variant>& variants);

}  // namespace demos
