/// MuJoCo's models (MJCF) as scenes; demos/mjcf/README.md says what becomes of each of their words.
#pragma once
#include <filesystem>

#include "demos/mjcf/xml_tree.h"
#include "demos/scene/description.h"

namespace demos::mjcf {

/// Throws SceneError of all that is wrong. What is not supported and changes the motion is in the
/// scene's notes. `read` gives the files that a model names. `overrides` as of a scene file, but
/// for bodies, joints and forces.
SceneDescription readModel(const std::string& text, const std::string& fileName,
                           const std::string& sceneName, const std::vector<std::string>& overrides,
                           const FileReader& read);

/// The model in a file. Throws SceneError.
SceneDescription loadModel(const std::filesystem::path& path,
                           const std::vector<std::string>& overrides);

}  // namespace demos::mjcf
