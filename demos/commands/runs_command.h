/// The options that `impulse compare` and `impulse sweep` share: several runs of one scene, shown
/// as a table, a film and a figure.
#pragma once
#include "demos/commands/shared_options.h"
#include "demos/comparisons/runs_options.h"

namespace demos {

void addRuns(CLI::App& app, RunsOptions& options, OptionTexts& texts);
/// Throws Stop (usage).
void checkRuns(const RunsOptions& options);

}  // namespace demos
