#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/film/progress.h"
#include "demos/scene/builtin.h"
#include "demos/scene/complaints.h"
#include "demos/scene/nearest.h"
#include "demos/scene/reader.h"
#include "demos/scene/schema.h"

namespace demos {
namespace {

const BuiltinScene& builtin(const std::string& name) {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) {
        if (scene.name == name) return scene;
        names.emplace_back(scene.name);
    }
    throw Stop(Exit::usage, fmt::format("no built-in scene is called '{}'{}", printable(name),
                                        suggestion(name, names)));
}

SceneDescription described(const BuiltinScene& scene) {
    const std::string name(scene.name);
    return readScene(scene.text, name, name);
}

void sayJson(const SceneDescription& scene) {
    fmt::print(R"({{"scene":{},"title":{},"seconds":{},"bodies":{},"joints":{},"hz":{}}})"
               "\n",
               jsonString(scene.name), jsonString(scene.title), numberText(scene.seconds),
               scene.bodies.size(), scene.joints.size(), scene.hz);
}

void sayAll(bool json) {
    for (const BuiltinScene& builtinScene : builtinScenes()) {
        const SceneDescription scene = described(builtinScene);
        if (json)
            sayJson(scene);
        else
            fmt::print("{:18} {:5} bodies {:4} joints {:5.3g} s  {}\n", scene.name,
                       scene.bodies.size(), scene.joints.size(), scene.seconds,
                       printable(scene.title));
    }
    if (!json) fmt::print("next: impulse render NAME, or impulse list NAME --print > my.toml\n");
}

void sayOne(const SceneDescription& scene) {
    fmt::print("{}: {}\n", scene.name, printable(scene.title));
    fmt::print("length   {:g} s, {} steps a second, solver {}\n", scene.seconds, scene.hz,
               scene.preset);
    fmt::print("bodies   {}\njoints   {}\n", scene.bodies.size(), scene.joints.size());
    for (const Section& section : scene.sections)
        fmt::print("section  {:g} s  {}  {}\n", section.at, printable(section.name),
                   printable(section.caption));
    fmt::print("expects  {} things; impulse sim {} checks them\n", scene.expectations.size(),
               scene.name);
    fmt::print("next: impulse render {}\n", scene.name);
}

}  // namespace

Exit listCommand(const Options& options) {
    if (options.schema) {
        if (!options.scenes.empty() || options.print || options.json)
            throw Stop(Exit::usage, "--schema stands alone, as in 'impulse list --schema'");
        fmt::print("{}", sceneSchema());
        return Exit::ok;
    }
    if (options.scenes.empty()) {
        if (options.print)
            throw Stop(Exit::usage, "--print needs a scene, as in 'impulse list stack --print'");
        sayAll(options.json);
        return Exit::ok;
    }
    const BuiltinScene& scene = builtin(options.scene());
    if (options.print)
        fmt::print("{}", scene.text);
    else if (options.json)
        sayJson(described(scene));
    else
        sayOne(described(scene));
    return Exit::ok;
}

}  // namespace demos
