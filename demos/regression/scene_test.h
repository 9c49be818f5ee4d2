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

/// The pictures of a test: of the scene's own size, drawn by one thread, since scenes share the
/// processor.
FilmPlan planOfTest(const ChosenScene& chosen, const TestOptions& options);

/// Which baselines a test writes.
enum class Update { none, missing, changed, all };

/// --update; unless given: missing, and none where the environment has CI=true.
Update updateOf(const TestOptions& options);

/// What holds for all scenes of one test.
struct TestSetup {
    const TestOptions& options;
    std::filesystem::path results;  // the folder of the report
    Update update = Update::missing;
    std::string renderer;           // its name
    const PassCache* cache = nullptr;  // null: nothing is left out
};

struct SceneTested {
    SceneVerdict verdict;
    std::uint64_t fingerprint = 0;  // of all that decides about the verdict; 0: it has none
};

/// Plays, draws, compares; leaves what was shown in results/NAME.snapshots unless all is as it was,
/// and writes the baseline where `update` says so. Nothing is thrown: what goes wrong is the
/// verdict's problem.
SceneTested testScene(const ChosenScene& chosen, const TestSetup& run) noexcept;

}  // namespace demos
