/// MuJoCo's models (MJCF) as scenes; demos/mjcf/README.md lists how each word is translated.
#pragma once
#include <filesystem>

#include "demos/mjcf/xml_tree.h"
#include "demos/scene/description.h"

namespace demos::mjcf {

/// Throws a SceneError with all errors. Unsupported features that change the motion are in the
/// scene's notes. `read` gives the files that a model names. `overrides`: as for a scene file,
/// except for bodies, joints and forces.
SceneDescription readModel(const std::string& text, const std::string& fileName,
                           const std::string& sceneName, const std::vector<std::string>& overrides,
                           const FileReader& read);

/// The model in a file. Throws SceneError.
SceneDescription loadModel(const std::filesystem::path& path,
                           const std::vector<std::string>& overrides);

}  // namespace demos::mjcf
