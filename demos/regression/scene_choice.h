/// The scenes that `impulse test` tests, and where their baselines are.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/regression/test_options.h"

namespace demos {

struct ChosenScene {
    std::string scene;             // as loadScene takes it
    std::string name;              // of its baseline: unique
    std::filesystem::path folder;  // of its baseline
};

struct SceneChoice {
    std::vector<ChosenScene> scenes;
    std::vector<std::string> orphans;  // folders NAME.snapshots whose scenes are gone, sorted
    std::vector<std::string> notes;    // files that were skipped, a line each
};

/// The folder that holds a scene's NAME.snapshots; `baselines`: the option; empty: not given.
std::filesystem::path homeOf(const std::string& scene, const std::string& baselines);

/// What a baseline in `folder` keeps of where its scene is: Baseline::home.
std::string homeSeenFrom(const std::filesystem::path& folder, const std::string& scene);

/// Whether a folder NAME.snapshots has lost its scene: there is no scene NAME where its own was. A
/// baseline that does not tell is compared with the scenes next to it; in the folder `baselines` it
/// is no orphan, as its scene may be anywhere.
bool isOrphan(const std::filesystem::path& folder, const std::string& baselines);

/// Throws SceneError for a word that is not a scene, Stop (usage) if two scenes have the same name
/// or a folder has no scene.
SceneChoice chooseScenes(const TestOptions& options);

}  // namespace demos
