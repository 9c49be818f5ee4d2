/// The runs that a [[slide]] names, read.
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
    std::vector<SceneDescription> scenes;  // one a run, in their order; none after a complaint
    std::string point;                     // of a built-in comparison: what one should see
};

/// scene, compare, set, vary, case, over. `folder`: what scenes are relative to. Complains of what
/// is not there, what does not read and what contradicts.
ReadRuns readRuns(Keys& keys, const std::filesystem::path& folder);

}  // namespace demos
