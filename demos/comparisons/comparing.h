/// What `impulse compare` compares.
#pragma once
#include <string>
#include <vector>

#include "demos/comparisons/runs_options.h"
#include "demos/film/variants.h"

namespace demos {

/// The most variants side by side in one film.
inline constexpr std::size_t kMostCompared = 4;

struct CompareOptions : RunsOptions {
    std::vector<std::string> vary, cases;  // KEY=VALUE,VALUE... | LABEL: KEY=VALUE KEY=VALUE
    bool film = true;                      // draw it
    bool strip = true;                     // a plot below the pictures
    bool listOnly = false;                 // list the built-in ones
};

struct Comparing {
    CompareOptions options;  // with the built-in comparison's scene and length
    std::string name, point;
    std::string plot;  // a measure
    std::vector<Variant> variants;
};

/// A built-in comparison, or options.vary, or options.cases of a scene: two to four variants.
/// Throws Stop (usage), SceneError.
Comparing comparingOf(const CompareOptions& options);

}  // namespace demos
