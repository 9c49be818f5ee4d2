/// One scene's test, from its file to its verdict.
#pragma once
#include <cstdint>
#include <filesystem>

#include "demos/film/film_plan.h"
#include "demos/regression/pass_cache.h"
#include "demos/regression/scene_choice.h"
#include "demos/regression/test_options.h"
#include "demos/regression/verdict.h"

namespace demos {

/// The plan of a test's pictures: of the scene's snapshot size, drawn by one thread, since scenes
/// share the processor.
FilmPlan planOfTest(const ChosenScene& chosen, const TestOptions& options);

/// Which baselines a test writes.
enum class Update { none, missing, changed, all };

/// The value of --update; default: missing, or none if the environment has CI.
Update updateOf(const TestOptions& options);

/// The settings of all scenes of one test.
struct TestSetup {
    const TestOptions& options;
    std::filesystem::path results;  // the folder of the report
    Update update = Update::missing;
    std::string renderer;           // its name
    const PassCache* cache = nullptr;  // null: nothing is skipped
};

struct SceneTested {
    SceneVerdict verdict;
    std::uint64_t fingerprint = 0;  // of all that affects the verdict; 0: none
};

/// Removes the files that an earlier test left in results/NAME.snapshots, and no others.
void removeShown(const std::filesystem::path& folder);

/// Simulates, draws and compares; writes the results to results/NAME.snapshots unless nothing
/// differs, and the baseline if `update` says so. Throws nothing: an error becomes the verdict's
/// `problem`.
SceneTested testScene(const ChosenScene& chosen, const TestSetup& run) noexcept;

}  // namespace demos
