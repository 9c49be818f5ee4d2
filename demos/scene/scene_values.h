/// A scene's values as keys and texts, by which two versions of it are compared: with those of the
/// files it includes and of --set, without comments, and whatever the order of the keys.
///
///   body.crate        [[body]]       every table of a list, called by its name
///   body.crate.at     [1.002, 0, 3]
///   expect.drift of ball.below  0.005
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace demos {

/// Sorted by key. Control bytes are escaped, long texts and lists are cut and end with their hash.
using SceneValues = std::vector<std::pair<std::string, std::string>>;

/// Of a scene that readScene() reads; the parameters are the same.
SceneValues sceneValues(std::string_view text, const std::string& fileName,
                        const std::vector<std::string>& overrides,
                        const std::optional<std::filesystem::path>& folder);

}  // namespace demos
