// impulse test --merge: one report from those of the parts of a test.

#include <fmt/format.h>

#include "demos/commands/test_report.h"
#include "demos/processes/folder_lock.h"
#include "demos/regression/test_parts.h"
#include "demos/text/complaints.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// The command of a part, by that of any part that is there; empty: unknown.
std::string commandOfPart(const std::vector<FoundTestPart>& parts, const Shard& shard) {
    for (const FoundTestPart& part : parts)
        if (part.report)
            return commandOf(part.report->command, "impulse test ", shard);
    return {};
}

/// Prints the commands of the missing parts, then ends the run.
[[noreturn]] void refuseParts(const PartReview& review, const std::vector<FoundTestPart>& parts,
                              const Talk& talk) {
    for (const int number : review.wanted) {
        const std::string command = commandOfPart(parts, {number, review.count});
        if (!command.empty()) talk.say("to do: " + printable(command));
        talk.json(fmt::format(R"({{"event":"wanted","shard":{},"command":{}}})", number,
                              jsonString(command)));
    }
    throw Stop(Exit::incomplete, fmt::format("{} of {} parts are complete; {}",
                                             review.good.size(), review.count,
                                             fmt::join(review.troubles, "; ")));
}

/// The folder for the whole must not be one of the parts' or of the baselines'.
void checkPlaces(const std::vector<FoundTestPart>& parts, const fs::path& results) {
    std::error_code ignored;
    const fs::path place = fs::weakly_canonical(fs::absolute(results), ignored);
    for (const FoundTestPart& part : parts) {
        if (fs::weakly_canonical(fs::absolute(part.folder), ignored) == place)
            refuse(fmt::format("--output '{}' is the folder of a part; name another folder",
                               printable(results.string())));
        if (!part.report) continue;
        for (const SceneVerdict& scene : part.report->scenes)
            checkApart(scene.name, scene.folder, results);
    }
}

}  // namespace

Exit mergeTest(const TestOptions& options) {
    const Talk talk(options, false);
    const fs::path results = resultsOf(options);
    std::vector<std::string> folders = options.scenes;
    if (folders.empty()) folders = {folderOfParts(results).string()};
    const std::vector<FoundTestPart> parts = testPartsIn(folders);
    const PartReview review = reviewed(parts);
    if (!review.wanted.empty()) refuseParts(review, parts, talk);
    checkPlaces(parts, results);
    render::makeFolder(results);
    const FolderLock lock(results);
    std::vector<const FoundTestPart*> good;
    for (const std::size_t i : review.good) good.push_back(&parts[i]);
    const TestVerdict verdict = mergedVerdict(good, results);
    talk.json(fmt::format(R"({{"event":"start","scenes":{}}})", verdict.scenes.size()));
    for (const SceneVerdict& scene : verdict.scenes) reportScene(scene, talk);
    TestOptions own = options;
    own.overrides = good.front()->report->part->settings;
    return finishTest(verdict, own, results, talk);
}

}  // namespace demos
