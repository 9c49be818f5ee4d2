/// The options that `impulse compare` and `impulse sweep` share: several runs of one scene, shown
/// as a table, a film and a figure; and the parts of such runs.
#pragma once
#include <vector>

#include "demos/commands/shared_options.h"
#include "demos/comparisons/run_parts.h"
#include "demos/comparisons/runs_options.h"
#include "demos/film/progress.h"
#include "demos/text/stop.h"

namespace demos {

void addRuns(CLI::App& app, RunsOptions& options, OptionTexts& texts);
/// Also moves --shard into the options. Throws Stop (usage).
void checkRuns(RunsOptions& options, const OptionTexts& texts);

/// --dry-run
Exit sayRuns(const std::vector<Variant>& variants, const RunsOptions& options);

/// --shard: simulates a part's runs, unless that was done.
Exit runPart(const RunsInParts& runs, const std::vector<Variant>& variants,
             const RunsOptions& options);

/// The measures of all runs: simulated, or with --merge from their parts. Throws Stop (incomplete)
/// if parts are missing, after printing their commands.
std::vector<Measured> measuredRuns(const RunsInParts& runs, const std::vector<Variant>& variants,
                                   const RunsOptions& options, const Talk& talk);

}  // namespace demos
