/// What `impulse compare` and `impulse sweep` take alike: several runs of one scene, as a table, as
/// a film and as a figure.
#pragma once
#include "demos/commands/shared_options.h"
#include "demos/comparisons/runs_options.h"

namespace demos {

void addRuns(CLI::App& app, RunsOptions& options, OptionTexts& texts);
/// Throws Stop (usage).
void checkRuns(const RunsOptions& options);

}  // namespace demos
