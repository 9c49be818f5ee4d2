/// Parts of a comparison or a sweep that several machines share: --shard and --merge.
///   output/chain-sweep.parts/003-of-016.json: the measures of every 16th run, from the third on
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/comparisons/measure_table.h"
#include "demos/comparisons/runs_options.h"
#include "demos/film/part_review.h"

namespace demos {

/// All runs of one command.
struct RunsInParts {
    std::filesystem::path folder;
    std::uint64_t run = 0;  // hash of what the measures depend on, besides the program
    bool histories = false;  // their values over time are kept too
};

/// `name`: "chain-sweep"; `options`: with the scene that is simulated.
RunsInParts inParts(const RunsOptions& options, const std::string& name,
                    const std::vector<Variant>& variants, bool histories);

/// Whether the part is there and complete. Throws Stop (wouldOverwrite) if it is of another run,
/// unless `overwrite`.
bool isDone(const RunsInParts& runs, const Shard& shard, bool overwrite);

/// `measured`: the part's runs, in order. Throws render::Error.
void writePart(const RunsInParts& runs, const Shard& shard, const std::vector<Summary>& measured);

/// What --merge finds.
struct RunsFound {
    PartReview review;
    std::vector<Summary> summaries;  // of all runs, if nothing is wanted
};

/// Reads all parts of `count` runs. Throws Stop (usage) if there are none.
RunsFound runsFound(const RunsInParts& runs, std::size_t count);

}  // namespace demos
