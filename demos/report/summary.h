/// A run in a few numbers, and how they went: what comparisons are made of.
#pragma once
#include <string>
#include <vector>

#include "demos/scene/stage.h"

namespace demos {

/// What is measured of a run; every one is better when smaller.
struct Measure {
    const char* name;  // column, and word of --plot
    const char* unit;
    const char* meaning;
};
/// drift, speed, penetration, separation, energy, residual, sweeps, ms
const std::vector<Measure>& measures();
/// Its place in measures(), or -1.
int measureCalled(const std::string& name);

struct Summary {
    std::vector<double> values;                // one per measure; of the whole run
    std::string diverged;                      // empty, or the line that says how
    std::vector<double> time;                  // s, of every step
    std::vector<std::vector<double>> history;  // per measure: a value a step
};

/// Plays the scene once, physics only. Throws Stop (interrupted) on a signal.
Summary summarize(const SceneDescription& scene);

}  // namespace demos
