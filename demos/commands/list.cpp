#include <fmt/format.h>

#include <algorithm>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/progress.h"
#include "demos/load/builtin.h"
#include "demos/scene/description.h"
#include "demos/scene/explain.h"
#include "demos/scene/reader.h"
#include "demos/scene/schema.h"
#include "demos/text/complaints.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

struct ListOptions : Options {
    bool print = false;   // the scene file itself
    bool schema = false;  // the JSON Schema of scene files
    std::string explain;  // a key of scene files; empty: none
};

SceneDescription described(const BuiltinScene& scene) {
    const std::string name(scene.name);
    return readScene(scene.text, name, name);
}

const BuiltinScene& builtin(const std::string& name) {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) {
        if (scene.name == name) return scene;
        names.emplace_back(scene.name);
    }
    throw Stop(Exit::usage, fmt::format("no built-in scene is called '{}'{}", printable(name),
                                        suggestion(name, names)));
}

void saySceneJson(const SceneDescription& scene) {
    fmt::print(R"({{"scene":{},"group":{},"title":{},"purpose":{},"seconds":{},"bodies":{},)"
               R"("joints":{},"hz":{}}})"
               "\n",
               jsonString(scene.name), jsonString(scene.group), jsonString(scene.title),
               jsonString(scene.purpose), numberText(scene.seconds), scene.bodies.size(),
               scene.joints.size(), scene.hz);
}

/// By group, then by name.
std::vector<SceneDescription> scenesByGroup() {
    std::vector<SceneDescription> scenes;
    for (const BuiltinScene& scene : builtinScenes()) scenes.push_back(described(scene));
    std::stable_sort(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) {
        return a.group < b.group;  // stable: within a group they stay sorted by name
    });
    return scenes;
}

void sayGroups() {
    std::string group;
    for (const SceneDescription& scene : scenesByGroup()) {
        if (scene.group != group)
            fmt::print("{}{}\n", group.empty() ? "" : "\n", printable(scene.group));
        group = scene.group;
        fmt::print("  {:18} {}\n", scene.name, printable(scene.purpose));
    }
    fmt::print("\nnext: impulse render NAME, impulse list NAME, or impulse gallery\n");
}

void sayOne(const SceneDescription& scene) {
    fmt::print("{}: {}\n", scene.name, printable(scene.title));
    fmt::print("{}: {}\n", printable(scene.group), printable(scene.purpose));
    fmt::print("length   {:g} s, {} steps a second, solver {}\n", scene.seconds, scene.hz,
               scene.preset);
    fmt::print("bodies   {}\njoints   {}\n", scene.bodies.size(), scene.joints.size());
    for (const Section& section : scene.sections)
        fmt::print("section  {:g} s  {}  {}\n", section.at, printable(section.name),
                   printable(section.caption));
    fmt::print("expects  {} results; impulse sim {} checks them\n", scene.expectations.size(),
               scene.name);
    fmt::print("next: impulse render {}\n", scene.name);
}

/// Prints what scene files may hold, if that is asked for.
bool sayFormat(const ListOptions& options) {
    if (!options.schema && options.explain.empty()) return false;
    const bool both = options.schema && !options.explain.empty();
    if (!options.scenes.empty() || options.print || options.json || both)
        throw Stop(Exit::usage,
                   options.schema
                       ? "--schema takes no scene and no other option: 'impulse list --schema'"
                       : "--explain takes a key and no other option: 'impulse list --explain "
                         "solver.sweeps'");
    fmt::print("{}", options.schema ? sceneSchema() : explanationOf(options.explain));
    return true;
}

Exit listScenes(const ListOptions& options) {
    if (sayFormat(options)) return Exit::ok;
    if (options.scenes.size() > 1)
        throw Stop(Exit::usage,
                   "several scenes: list describes one; impulse gallery draws several");
    if (options.scenes.empty()) {
        if (options.print)
            throw Stop(Exit::usage, "--print needs a scene, as in 'impulse list stack --print'");
        if (!options.json) sayGroups();
        else for (const SceneDescription& scene : scenesByGroup()) saySceneJson(scene);
        return Exit::ok;
    }
    const BuiltinScene& scene = builtin(options.scene());
    if (options.print)
        fmt::print("{}", scene.text);
    else if (options.json)
        saySceneJson(described(scene));
    else
        sayOne(described(scene));
    return Exit::ok;
}

Run addList(CLI::App& app) {
    const auto asked = std::make_shared<Asked<ListOptions>>();
    auto& options = asked->options;
    app.add_option("scene", options.scenes, "a scene to describe; default: all")
        ->type_name("SCENE")
        ->expected(0, kMostScenes);
    app.add_flag("--print", options.print, "print the scene file itself; default: off");
    app.add_flag("--schema", options.schema,
                 "print the JSON Schema of scene files, for editors; default: off");
    app.add_option("--explain", options.explain,
                   "what a key of a scene file does: its type, unit, default and range; scene: all "
                   "tables; default: none")
        ->type_name("KEY");
    addFeedback(app, options);
    return [asked](const std::string& commandLine) {
        return listScenes(settled(*asked, commandLine));
    };
}

}  // namespace

Command listCommand() {
    return {"list",
            "the built-in scenes",
            {"impulse list", "impulse list stack --print > my.toml",
             "impulse list --explain solver.sweeps"},
            addList};
}

}  // namespace demos
