/// From a scene file's text to its description. Strict: anything not understood is an error.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace demos {

class Catalog;
struct SceneDescription;

/// All errors of one scene, a line each: `file:line:column: what is wrong, its value, what would be
/// right`, in the order of the file. Control bytes are escaped.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(std::vector<std::string> lines);
    const std::vector<std::string>& lines() const { return lines_; }

private:
    std::vector<std::string> lines_;
};

/// `overrides`: "world.hz=240", applied before anything is read, as if written in the file.
/// `folder`: that of the files which the scene names; without it the scene cannot name any.
SceneDescription readScene(std::string_view text, const std::string& fileName,
                           const std::string& sceneName,
                           const std::vector<std::string>& overrides = {},
                           const std::optional<std::filesystem::path>& folder = std::nullopt);

/// A file's name without its extension; outputs are named after it. Throws SceneError for "..",
/// which is a folder.
std::string sceneNameOf(const std::filesystem::path& file);

constexpr std::uintmax_t kMostPartBytes = 64u << 20;  // of a file that a scene names, like a mesh

/// The text of a regular file of at most `most` bytes. Otherwise throws a SceneError, which states
/// what the path is; `what`: what it should be.
std::string readSceneFile(const std::filesystem::path& path, const char* what = "a scene file",
                          std::uintmax_t most = 8u << 20);

/// Reads the text, records every key that the reader asks for, and gives the errors.
std::vector<std::string> catalogScene(std::string_view text, const std::string& name,
                                      Catalog& catalog);

}  // namespace demos
