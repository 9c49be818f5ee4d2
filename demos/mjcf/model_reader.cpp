#include "demos/mjcf/model_reader.h"

#include "demos/mjcf/contact_filter.h"
#include "demos/mjcf/equalities.h"
#include "demos/mjcf/joints.h"
#include "demos/mjcf/tendons.h"
#include "demos/mjcf/view.h"
#include "demos/mjcf/vocabulary.h"
#include "demos/scene/expression.h"
#include "demos/scene/overrides.h"
#include "demos/scene/reader.h"
#include "demos/scene/repeat.h"
#include "demos/scene/table_readers.h"

namespace demos::mjcf {
namespace {

namespace fs = std::filesystem;

void stopIfWrong(const Diagnostics& diagnostics) {
    if (diagnostics.errors() > 0) throw SceneError(diagnostics.errorLines());
}

void build(const Element& root, const fs::path& folder, const FileReader& read,
           Diagnostics& diagnostics, SceneDescription& scene) {
    const Defaults defaults(root, diagnostics);
    const Rules rules = readRules(root, defaults, scene, diagnostics);
    const Assets assets = readAssets(root, defaults, rules, folder, read, diagnostics);
    const Context context{rules, defaults, assets, diagnostics};
    const BodyTree tree = readBodies(root, context);
    const std::vector<int> places = addBodies(tree, context, scene);
    stopIfWrong(diagnostics);  // joints need valid bodies
    Names jointNames;
    Actuation actuation = readActuators(root, context);
    addFixedTendons(root, tree, context, actuation);
    addJoints(tree, places, context, actuation.joints, scene, jointNames);
    addSpatialTendons(root, tree, places, context, actuation, scene, jointNames);
    addEqualities(root, tree, places, context, scene, jointNames);
    separate(root, tree, places, context, scene);
    if (scene.joints.size() > kMostJoints)
        diagnostics.wrong(root.spot, "the model makes " + std::to_string(scene.joints.size()) +
                                         " joints; it should make at most " + std::to_string(kMostJoints));
    if (scene.bodies.empty())
        diagnostics.wrong(
            root.spot,
            "the model has no <geom>; give it some" +
                (tree.lacking.empty() ? "" : ": its <" + tree.lacking + "> is not supported"));
    scene.camera = readView(root, defaults, scene);
    stopIfWrong(diagnostics);
}

/// --set, as if a scene file with these settings followed the model.
void applyOptions(const std::vector<std::string>& overrides, const std::string& fileName,
                  SceneDescription& scene) {
    Complaints complaints(overrides);
    complaints.addFile(fileName);
    Value document;
    document.place = {1, 1};
    for (const ItemOverride& change : applyOverrides(overrides, document, complaints))
        complaints.add(change.place, "unknown key '" + change.list + "' in a model");
    BodyNumbers numbers;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        numbers[scene.bodies[i].name] = static_cast<int>(i);
    Expressions expressions;
    const Scope scope{&expressions, {}, nullptr};
    Keys top(document, "a model", complaints, scope);
    scene.title = top.text("title").value_or(scene.title);
    scene.seconds = top.number("seconds", {0.01, 1e5, "s"}).value_or(scene.seconds);
    readWorld(top, scene);
    readSolver(top, scene);
    readCamera(top, numbers, scene);
    readLook(top, scene);
    readSections(top, scene);
    readExpectations(top, scene);
    readSnapshot(top, scene);
    top.done();
    if (complaints.count() > 0) throw SceneError(complaints.lines());
}

}  // namespace

SceneDescription readModel(const std::string& text, const std::string& fileName,
                           const std::string& sceneName, const std::vector<std::string>& overrides,
                           const FileReader& read) {
    SceneDescription scene;
    scene.name = scene.title = sceneName;
    std::uintmax_t bytes = text.size();
    const FileReader noted = [&](const fs::path& path) {
        scene.files.push_back(path.string());
        std::string content = read(path);
        if ((bytes += content.size()) > kMostModelBytesInAll)
            throw SceneError({"with it, more than 128 MiB are read; use fewer files"});
        return content;
    };
    Diagnostics diagnostics;
    const Element root = readTree(text, fileName, noted, diagnostics);
    stopIfWrong(diagnostics);
    if (const Attribute* model = root.find("model"); model && !model->value.empty())
        scene.title = printable(model->value.substr(0, 200));
    checkWords(root, diagnostics);
    build(root, fs::path(fileName).parent_path(), noted, diagnostics, scene);
    scene.notes = diagnostics.noteLines();
    applyOptions(overrides, fileName, scene);
    return scene;
}

SceneDescription loadModel(const fs::path& path, const std::vector<std::string>& overrides) {
    return readModel(
        readSceneFile(path), path.string(), sceneNameOf(path), overrides,
        [](const fs::path& file) {
            return readSceneFile(file, "a file of the model", kMostModelBytes);
        });
}

}  // namespace demos::mjcf
