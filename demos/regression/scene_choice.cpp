#include "demos/regression/scene_choice.h"
#include "demos/load/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "demos/load/builtin.h"
#include "demos/regression/baseline.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sorted(const fs::path& folder, const char* ending) {
    std::vector<fs::path> paths;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ending) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// A file without `format` is a part that scenes include.
bool hasFormat(const fs::path& file) {
    const std::string text = "\n" + readSceneFile(file);
    for (std::size_t at = 0; (at = text.find("\nformat", at)) != text.npos; ++at)
        if (const std::size_t next = text.find_first_not_of(" \t", at + 7);
            next != text.npos && text[next] == '=')
            return true;
    return false;
}

class Chooser {
public:
    explicit Chooser(const TestOptions& options) : options_(options) {}

    SceneChoice choose() {
        for (const std::string& word : options_.scenes) add(word);
        if (options_.scenes.empty())
            for (const BuiltinScene& scene : builtinScenes()) addScene(std::string(scene.name));
        findOrphans();
        return std::move(choice_);
    }

private:
    void add(const std::string& word) {
        std::error_code ignored;
        if (!isBuiltin(word) && fs::is_directory(word, ignored)) return addFolder(word);
        whole_ = false;
        loadScene(word, options_.overrides);  // throws if it is not a scene
        addScene(word);
    }

    void addFolder(const fs::path& folder) {
        const std::size_t before = choice_.scenes.size();
        for (const fs::path& file : sorted(folder, ".toml")) {
            if (hasFormat(file))
                addScene(file.string());
            else
                choice_.notes.push_back(fmt::format(
                    "{}: has no 'format = 1', so it is a part of other scenes; left out",
                    printable(file.string())));
        }
        if (choice_.scenes.size() == before)
            throw Stop(Exit::usage, fmt::format("'{}' holds no scene file (*.toml with format = 1)",
                                                printable(folder.string())));
    }

    void addScene(const std::string& scene) {
        const std::string name = isBuiltin(scene) ? scene : sceneNameOf(scene);
        const auto [known, added] = names_.emplace(name, scene);
        if (!added && known->second == scene) return;
        if (!added)
            throw Stop(Exit::usage,
                       fmt::format("'{}' and '{}' are both called '{}'; test them separately, each "
                                   "with its own folders of results (-o) and baselines",
                                   printable(known->second), printable(scene), printable(name)));
        const fs::path home = homeOf(scene, options_.baselines);
        homes_.insert(home);
        choice_.scenes.push_back({scene, name, home / (name + kSnapshotsEnding)});
    }

    /// Only if no scene was named: otherwise the other baselines there belong to other scenes.
    void findOrphans() {
        if (!whole_) return;
        for (const fs::path& home : homes_)
            for (const fs::path& folder : sorted(home.empty() ? "." : home, kSnapshotsEnding)) {
                std::error_code ignored;
                if (!names_.count(folder.stem().string()) &&
                    fs::exists(folder / kBaselineFile, ignored) &&
                    isOrphan(folder, options_.baselines))
                    choice_.orphans.push_back(folder.string());
            }
    }

    const TestOptions& options_;
    SceneChoice choice_;
    std::map<std::string, std::string> names_;
    std::set<fs::path> homes_;
    bool whole_ = true;
};

/// Empty if the baseline cannot be read.
std::string homeIn(const fs::path& folder) try {
    const std::optional<Baseline> baseline = readBaseline(folder);
    return baseline ? baseline->home : "";
} catch (const BaselineError&) {
    return "";
}

bool hasSceneFile(const fs::path& home, const std::string& name) {
    std::error_code ignored;
    return fs::exists(home / (name + ".toml"), ignored) ||
           fs::exists(home / (name + ".xml"), ignored);
}

}  // namespace

fs::path homeOf(const std::string& scene, const std::string& baselines) {
    if (!baselines.empty()) return baselines;
    return isBuiltin(scene) ? fs::path("snapshots") : fs::path(scene).parent_path();
}

std::string homeSeenFrom(const fs::path& folder, const std::string& scene) {
    if (isBuiltin(scene)) return kBuiltinHome;
    std::error_code ignored;
    const fs::path home = fs::absolute(fs::path(scene), ignored).parent_path();
    return fs::relative(home, fs::absolute(folder, ignored), ignored).string();
}

bool isOrphan(const fs::path& folder, const std::string& baselines) {
    const std::string home = homeIn(folder), name = folder.stem().string();
    if (home == kBuiltinHome) return !isBuiltin(name);
    if (!home.empty())  // baselines that were moved see no folder: nothing is known of their scenes
        return fs::is_directory(folder / home) && !hasSceneFile(folder / home, name);
    const fs::path here = folder.parent_path();
    return baselines.empty() && !hasSceneFile(here, name) &&
           !(isBuiltin(name) && here.filename() == homeOf(name, ""));
}

SceneChoice chooseScenes(const TestOptions& options) { return Chooser(options).choose(); }

}  // namespace demos
