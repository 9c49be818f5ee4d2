#include "demos/regression/test_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/outputs.h"
#include "demos/regression/accept.h"
#include "demos/regression/baseline.h"
#include "demos/regression/verdict_json.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/json_limits.h"
#include "demos/text/program_bytes.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// Of what all parts have in common; their baselines may change while the first parts run.
std::uint64_t hashOfRun(const SceneChoice& choice, const TestOptions& options) {
    TextHash hash;
    for (const ChosenScene& scene : choice.scenes) {
        hash.add(scene.scene);
        hash.add(scene.folder.string());
        hash.add(contentOf(scene.scene));  // none of a built-in scene: the program has it
    }
    for (const std::string& setting : options.overrides) hash.add(setting);
    hash.add(options.baselines);
    hash.add(std::to_string(static_cast<int>(updateOf(options))));
    if (options.size) hash.add(fmt::format("{}x{}", options.size->width, options.size->height));
    hash.add(options.reproducible ? "reproducible" : "as fast as possible");
    return hash.value();
}

/// A name is one folder's: it cannot lead elsewhere.
bool isFolderName(const std::string& name) {
    return !name.empty() && name != "." && name != ".." && name.find('\0') == std::string::npos &&
           fs::path(name).filename() == name;
}

/// Nothing if there is no report of a part that can be used.
std::optional<TestVerdict> reportAt(const fs::path& folder) try {
    const fs::path file = folder / "report.json";
    const std::vector<std::uint8_t> bytes = contentOf(file, kReportJson.bytes);
    if (bytes.empty()) return std::nullopt;
    TestVerdict verdict = testVerdictFrom({bytes.begin(), bytes.end()}, file.string());
    const bool named = std::ranges::all_of(
        verdict.scenes, [](const SceneVerdict& scene) { return isFolderName(scene.name); });
    return verdict.part && named ? std::optional(std::move(verdict)) : std::nullopt;
} catch (const Stop&) {
    return std::nullopt;
}

/// A folder of a part is known by its report, or by its name where that is missing.
std::optional<FoundTestPart> partAt(const fs::path& folder) {
    FoundTestPart found{folder, {}, reportAt(folder)};
    std::optional<Shard> shard = shardNamed(folder.filename().string());
    if (found.report) shard = found.report->part->shard;
    if (!shard) return std::nullopt;
    found.shard = *shard;
    return found;
}

int scenesIn(const TestPart& part) {
    const Shard& shard = part.shard;
    return part.scenes < shard.number ? 0 : (part.scenes - shard.number) / shard.count + 1;
}

PartSeen seenOf(const FoundTestPart& found) {
    PartSeen seen{found.shard, found.report.has_value(), false, 0, "", ""};
    if (!found.report) return seen;
    const TestVerdict& report = *found.report;
    seen.whole = static_cast<int>(report.scenes.size()) == scenesIn(*report.part);
    seen.run = hashOf(fmt::format("{} {}", report.part->run, report.part->scenes));
    seen.program = report.part->program + " " + report.renderer;
    seen.pixels = report.pixels;
    return seen;
}

/// Copies what a part drew of a scene, and names the copies in the verdict.
void moveShown(SceneVerdict& scene, const fs::path& part, const fs::path& results) {
    const fs::path from = part / (scene.name + kSnapshotsEnding);
    const fs::path to = results / (scene.name + kSnapshotsEnding);
    removeShown(to);
    std::error_code ignored;
    if (fs::exists(from / kBaselineFile, ignored)) acceptAll(from, to);
    for (PictureVerdict& picture : scene.pictures) {
        const std::string file = pictureFile(picture.time);
        if (!picture.actual.empty()) picture.actual = (to / file).string();
        if (!picture.baseline.empty()) picture.baseline = (fs::path(scene.folder) / file).string();
    }
}

}  // namespace

fs::path folderOfPart(const fs::path& results, const Shard& shard) {
    return folderOfParts(results) / shard.name();
}

fs::path folderOfParts(const fs::path& results) {
    fs::path folder = results.lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();
    return folder += ".parts";
}

TestPart keepPart(SceneChoice& choice, const TestOptions& options) {
    checkShard(*options.shard, choice.scenes.size(), "scenes");
    TestPart part{*options.shard, static_cast<int>(choice.scenes.size()),
                  hashOfRun(choice, options), programName(), options.overrides};
    std::vector<ChosenScene> own;
    for (std::size_t i = 0; i < choice.scenes.size(); ++i)
        if (isIn(part.shard, i)) own.push_back(choice.scenes[i]);
    choice.scenes = std::move(own);
    return part;
}

std::vector<FoundTestPart> testPartsIn(const std::vector<std::string>& folders) {
    std::vector<FoundTestPart> all;
    for (const std::string& folder : folders) {
        if (std::optional<FoundTestPart> part = partAt(folder)) {
            all.push_back(std::move(*part));
            continue;
        }
        const std::size_t before = all.size();
        std::error_code ignored;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
            if (std::optional<FoundTestPart> part = partAt(entry.path()))
                all.push_back(std::move(*part));
        if (all.size() == before)
            refuse(fmt::format("'{}' has no part of a test; make them with impulse test --shard "
                               "1/N, and name their folders",
                               printable(folder)));
    }
    std::ranges::sort(all, {}, [](const FoundTestPart& part) { return part.shard.number; });
    return all;
}

PartReview reviewed(const std::vector<FoundTestPart>& parts) {
    std::vector<PartSeen> seen;
    for (const FoundTestPart& part : parts) seen.push_back(seenOf(part));
    return reviewed(seen, parts.front().folder.parent_path().string());
}

TestVerdict mergedVerdict(const std::vector<const FoundTestPart*>& parts,
                          const fs::path& results) {
    const TestPart& first = *parts.front()->report->part;
    TestVerdict whole = *parts.front()->report;
    whole.part.reset();
    whole.command = commandOfWhole(whole.command, "impulse test ");
    whole.scenes.clear();
    for (int i = 0; i < first.scenes; ++i) {
        const auto count = static_cast<int>(parts.size());
        const FoundTestPart& part = *parts[static_cast<std::size_t>(i % count)];
        SceneVerdict scene = part.report->scenes[static_cast<std::size_t>(i / count)];
        try {
            moveShown(scene, part.folder, results);
        } catch (const BaselineError& error) {
            throw Stop(Exit::incomplete,
                       fmt::format("part {} of {}: {}; run it again: {}", part.shard.number,
                                   count, error.what(), printable(part.report->command)));
        }
        whole.scenes.push_back(std::move(scene));
    }
    return whole;
}

}  // namespace demos
