/// Which scenes `impulse test` is about, and where their baselines are.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/regression/test_options.h"

namespace demos {

struct ChosenScene {
    std::string scene;             // as loadScene takes it
    std::string name;              // its baseline's: unique
    std::filesystem::path folder;  // of its baseline
};

struct SceneChoice {
    std::vector<ChosenScene> scenes;
    std::vector<std::string> orphans;  // folders NAME.snapshots without a scene NAME, sorted
    std::vector<std::string> notes;    // files that were left out, a line each
};

/// Throws SceneError for what is no scene, Stop (usage) where two have one name, or a folder has
/// none.
SceneChoice chooseScenes(const TestOptions& options);

}  // namespace demos
