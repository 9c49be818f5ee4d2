/// Loads a scene by its name: built in, a scene file, or a MuJoCo model.
#pragma once
#include <string>
#include <vector>

#include "demos/scene/scene_values.h"

namespace demos {

struct SceneDescription;

/// `nameOrPath`: a built-in name or a path. Throws SceneError; for an unknown name it suggests the
/// nearest.
SceneDescription loadScene(const std::string& nameOrPath,
                           const std::vector<std::string>& overrides = {});

/// A valid scene's values, to compare two versions of it. A MuJoCo model has none but --set.
SceneValues valuesOf(const std::string& nameOrPath, const std::vector<std::string>& overrides);

/// The text of a valid scene, with that of all files it includes.
std::string sceneText(const std::string& nameOrPath);

}  // namespace demos
