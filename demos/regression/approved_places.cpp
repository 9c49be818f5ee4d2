#include "demos/regression/approved_places.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/load/builtin.h"
#include "demos/regression/baseline.h"
#include "demos/regression/scene_choice.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// Without links; an empty path is the current folder.
fs::path realPath(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, ignored), ignored);
}

bool isHere(const fs::path& folder) {
    const fs::path real = realPath(folder), here = realPath(".");
    return std::mismatch(here.begin(), here.end(), real.begin(), real.end()).first == here.end();
}

std::string quoted(const std::string& text) { return "'" + printable(shown(text)) + "'"; }

[[noreturn]] void refusePlace(const std::string& what) {
    throw Stop(Exit::environment, "the report " + what +
                                      "; run impulse test again, or name the folder of the "
                                      "baselines with --baselines");
}

/// A name is one folder's: it cannot lead elsewhere.
void checkSceneName(const std::string& name) {
    const bool good = !name.empty() && name != "." && name != ".." &&
                      name.find('\0') == std::string::npos && fs::path(name).filename() == name;
    if (!good) refusePlace("has a scene called " + quoted(name) + ", which is not a scene's name");
}

/// Otherwise a report could choose whose times tell which pictures are left over.
void checkSceneFile(const SceneVerdict& scene) {
    const bool own = isBuiltin(scene.scene) ? scene.scene == scene.name : sceneNameOf(scene.scene) == scene.name;
    if (!own) refusePlace("has " + quoted(scene.name) + " from " + quoted(scene.scene) + ", which is another scene");
}

/// The scene must be here: otherwise a report could choose the folder.
void checkSceneHere(const SceneVerdict& scene) {
    std::error_code ignored;
    if (isBuiltin(scene.scene) && scene.scene == scene.name) return;
    const fs::path file(scene.scene);
    if (file.stem() == scene.name && isHere(file.parent_path()) &&
        fs::is_regular_file(file, ignored))
        return;
    refusePlace("has " + quoted(scene.name) + " from " + quoted(scene.scene) +
                ", which is not a scene file in this folder");
}

/// A path ends there for the system, but not for fs::path.
bool holdsNul(const std::string& path) { return path.find('\0') != std::string::npos; }

fs::path placeOf(const SceneVerdict& scene, const std::string& baselines) {
    checkSceneName(scene.name);
    for (const std::string& path : {scene.scene, scene.folder})
        if (holdsNul(path)) refusePlace("has a path with a zero byte, " + quoted(path));
    checkSceneFile(scene);
    if (baselines.empty()) checkSceneHere(scene);
    const fs::path place = homeOf(scene.scene, baselines) / (scene.name + kSnapshotsEnding);
    if (baselines.empty() && realPath(place) != realPath(scene.folder))
        refusePlace("has the baselines of " + quoted(scene.name) + " in " + quoted(scene.folder) +
                    ", not next to the scene");
    return place;
}

/// Orphans are found where scenes have their baselines, nowhere else. `scenes`: real paths.
fs::path orphanAt(const std::string& orphan, const std::string& baselines,
                  const std::vector<fs::path>& scenes) {
    const fs::path folder(orphan), real = realPath(folder);
    const bool beside = std::ranges::any_of(
        scenes, [&](const fs::path& scene) { return scene.parent_path() == real.parent_path(); });
    if (folder.extension() == kSnapshotsEnding && orphan.find('\0') == std::string::npos &&
        beside && std::ranges::find(scenes, real) == scenes.end() && isOrphan(folder, baselines))
        return folder;
    refusePlace("calls " + quoted(orphan) + " a baseline without a scene, which it is not");
}

}  // namespace

ApprovedPlaces approvedPlaces(const TestVerdict& report, const std::string& baselines) {
    ApprovedPlaces places;
    std::vector<fs::path> real;
    for (const SceneVerdict& scene : report.scenes) {
        places.scenes.push_back(placeOf(scene, baselines));
        real.push_back(realPath(places.scenes.back()));
    }
    for (const std::string& orphan : report.orphans)
        places.orphans.push_back(orphanAt(orphan, baselines, real));
    return places;
}

}  // namespace demos
