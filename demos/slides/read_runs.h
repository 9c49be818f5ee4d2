/// Reads the runs that a [[slide]] names.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/scene/keys.h"
#include "demos/slides/deck.h"

namespace demos {

struct ReadRuns {
    SlideRuns runs;
    std::vector<SceneDescription> scenes;  // one per run, in order; none after a complaint
    std::string point;                     // of a built-in comparison: what it shows
};

/// Reads scene, compare, set, vary, case, over. `folder`: scenes are relative to it. Complains
/// about missing scenes, invalid scenes and contradictions.
ReadRuns readRuns(Keys& keys, const std::filesystem::path& folder);

}  // namespace demos
