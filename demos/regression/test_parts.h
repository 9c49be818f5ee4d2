/// Parts of a test that several machines share: impulse test --shard and --merge.
///   results.parts/003-of-016/report.json, NAME.snapshots ...
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/film/part_review.h"
#include "demos/regression/scene_test.h"

namespace demos {

/// The folder of all parts' results, and of one's; `results`: of the whole test.
std::filesystem::path folderOfParts(const std::filesystem::path& results);
std::filesystem::path folderOfPart(const std::filesystem::path& results, const Shard& shard);

/// Leaves the scenes of options.shard in `choice`, and describes the part. Throws Stop (usage) if
/// there are more parts than scenes.
TestPart keepPart(SceneChoice& choice, const TestOptions& options);

/// The report of a part, and where it is.
struct FoundTestPart {
    std::filesystem::path folder;
    Shard shard;
    std::optional<TestVerdict> report;  // nothing: none that can be read
};

/// The parts in these folders: each is of one part, or has those of several. Throws Stop (usage)
/// for a folder without any.
std::vector<FoundTestPart> testPartsIn(const std::vector<std::string>& folders);

PartReview reviewed(const std::vector<FoundTestPart>& parts);

/// The verdict of the whole test from all of its parts, by number. Copies what they drew of scenes
/// that differ into `results`. Throws Stop (incomplete) for a part whose files have changed;
/// render::Error.
TestVerdict mergedVerdict(const std::vector<const FoundTestPart*>& parts,
                          const std::filesystem::path& results);

}  // namespace demos
