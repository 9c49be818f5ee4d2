#include "demos/load/load_scene.h"

#include "demos/load/builtin.h"
#include "demos/scene/description.h"
#include "demos/scene/include.h"
#include "demos/scene/reader.h"
#include "demos/text/nearest.h"
#ifdef IMPULSE_HAVE_MJCF
#include "demos/mjcf/model_reader.h"
#endif

namespace demos {
namespace {

namespace fs = std::filesystem;

const BuiltinScene* findBuiltin(const std::string& name) {
    for (const BuiltinScene& scene : builtinScenes())
        if (scene.name == name) return &scene;
    return nullptr;
}

/// For a name that cannot be a path: reports the nearest name.
[[noreturn]] void failUnknown(const std::string& name) {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.emplace_back(scene.name);
    throw SceneError({printable("there is no built-in scene and no file '" + name + "'" +
                                suggestion(name, names))});
}

[[noreturn]] void failUrdf(const fs::path& path) {
    throw SceneError({printable(path.string() +
                                ": URDF is not supported; MuJoCo's models (MJCF, .xml) are, and "
                                "MuJoCo's 'compile' program converts URDF to MJCF")});
}

SceneDescription loadModel(const fs::path& path, const std::vector<std::string>& overrides) {
#ifdef IMPULSE_HAVE_MJCF
    return mjcf::loadModel(path, overrides);
#else
    static_cast<void>(overrides);
    throw SceneError(
        {printable(path.string() + ": MuJoCo's models are not supported by this build; "
                                   "build with -DIMPULSE_MJCF=ON")});
#endif
}

}  // namespace

SceneDescription loadScene(const std::string& nameOrPath,
                           const std::vector<std::string>& overrides) {
    if (const BuiltinScene* scene = findBuiltin(nameOrPath))
        return readScene(scene->text, nameOrPath + ".toml", nameOrPath, overrides);
    const fs::path path(nameOrPath);
    std::error_code error;
    if (path.extension() == ".urdf") failUrdf(path);
    const bool isModel = path.extension() == ".xml";
    const bool isPath =
        nameOrPath.find('/') != std::string::npos || isModel || path.extension() == ".toml";
    if (!isPath && !fs::exists(path, error)) failUnknown(nameOrPath);
    if (isModel) return loadModel(path, overrides);
    return readScene(readSceneFile(path), nameOrPath, sceneNameOf(path), overrides,
                     path.parent_path());
}

SceneValues valuesOf(const std::string& nameOrPath, const std::vector<std::string>& overrides) {
    if (const BuiltinScene* scene = findBuiltin(nameOrPath))
        return sceneValues(scene->text, nameOrPath + ".toml", overrides, std::nullopt);
    const fs::path path(nameOrPath);
    if (path.extension() == ".xml") return sceneValues("", nameOrPath, overrides, std::nullopt);
    return sceneValues(readSceneFile(path), nameOrPath, overrides, path.parent_path());
}

std::string sceneText(const std::string& nameOrPath) {
    if (const BuiltinScene* scene = findBuiltin(nameOrPath)) return std::string(scene->text);
    if (fs::path(nameOrPath).extension() == ".xml") return readSceneFile(nameOrPath);
    Complaints ignored;
    return readDocument(readSceneFile(nameOrPath), nameOrPath, fs::path(nameOrPath), ignored).text;
}

}  // namespace demos
