/// The built-in scenes: the files of demos/scenes, embedded.
#pragma once
#include <span>
#include <string_view>

namespace demos {

struct BuiltinScene {
    std::string_view name, text;
};

/// Sorted by name.
std::span<const BuiltinScene> builtinScenes();

inline bool isBuiltin(std::string_view name) {
    for (const BuiltinScene& scene : builtinScenes())
        if (scene.name == name) return true;
    return false;
}

}  // namespace demos
