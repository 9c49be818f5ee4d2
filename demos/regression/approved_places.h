/// Where `impulse approve` may write and remove. A report may come from another machine: its places
/// are only compared with those that the command line and the scenes here give.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/regression/verdict.h"

namespace demos {

struct ApprovedPlaces {
    std::vector<std::filesystem::path> scenes;   // of the baselines, in the report's order
    std::vector<std::filesystem::path> orphans;  // baselines without a scene
};

/// `baselines`: the folder of all NAME.snapshots. Empty: each is next to its scene, which must be
/// built in or a file in the current folder or below it. Throws Stop (environment) if the report
/// names any other place.
ApprovedPlaces approvedPlaces(const TestVerdict& report, const std::string& baselines);

}  // namespace demos
