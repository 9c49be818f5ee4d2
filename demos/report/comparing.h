/// What `impulse compare` compares.
#pragma once
#include <string>
#include <vector>

#include "demos/options.h"
#include "demos/report/variants.h"

namespace demos {

/// Side by side in one film.
inline constexpr std::size_t kMostCompared = 4;

struct Comparing {
    Options options;  // with the built-in comparison's scene and length
    std::string name, point;
    std::string plot;  // a measure
    std::vector<Variant> variants;
};

/// A built-in comparison, or options.vary, or options.cases of a scene: two to four variants.
/// Throws Stop (usage), SceneError.
Comparing comparingOf(const Options& options);

}  // namespace demos
