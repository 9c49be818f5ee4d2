/// From a scene file's text to its description. Strict: what is not understood is an error.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "demos/scene/description.h"

namespace demos {

class Catalog;

/// All that is wrong with one scene, a line each: `file:line:column: what, value, what would be
/// right`, in the order of the file. Control bytes are escaped.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(std::vector<std::string> lines);
    const std::vector<std::string>& lines() const { return lines_; }

private:
    std::vector<std::string> lines_;
};

/// `overrides`: "world.hz=240", set before anything is read, as if the file had said so. `folder`:
/// of the files that the scene names; without one it may name none.
SceneDescription readScene(std::string_view text, const std::string& fileName,
                           const std::string& sceneName,
                           const std::vector<std::string>& overrides = {},
                           const std::optional<std::filesystem::path>& folder = std::nullopt);

/// A file's name without its ending, which names outputs too. Throws SceneError for "..", which
/// would be a folder.
std::string sceneNameOf(const std::filesystem::path& file);

constexpr std::uintmax_t kMostPartBytes = 64u << 20;  // of a mesh, say

/// A regular file of at most so many bytes, 8 MiB unless given, or an error (SceneError) that says
/// what it is instead.
std::string readSceneFile(const std::filesystem::path& path, const char* what = "a scene file",
                          std::uintmax_t most = 8u << 20);

/// What the reader asks of which table while it reads such a text, and its complaints.
std::vector<std::string> catalogScene(std::string_view text, const std::string& name,
                                      Catalog& catalog);

}  // namespace demos
