/// What `impulse test` prints and writes, for a whole test and for one merged from parts.
#pragma once
#include <filesystem>

#include "demos/film/progress.h"
#include "demos/regression/test_options.h"
#include "demos/regression/verdict.h"
#include "demos/text/stop.h"

namespace demos {

/// The folder of the results of the whole test: --output, or the default.
std::filesystem::path resultsOf(const TestOptions& options);

/// Refuses to write results over a scene's baseline in `folder`: a test deletes the results of the
/// test before.
void checkApart(const std::string& name, const std::filesystem::path& folder,
                const std::filesystem::path& results);

/// A scene's lines; failures are reported even with --quiet, on standard error.
void reportScene(const SceneVerdict& scene, const Talk& talk);

/// Writes the report and its summary. Returns `failed` if a scene failed.
Exit finishTest(const TestVerdict& verdict, const TestOptions& options,
                const std::filesystem::path& results, const Talk& talk);

/// impulse test --merge
Exit mergeTest(const TestOptions& options);

}  // namespace demos
