/// A command in one place: what it is called and for, its options, what it does.
#pragma once
#include <functional>
#include <string>

#include "demos/text/stop.h"

namespace CLI {
class App;
}

namespace demos {

/// What a command does once its options are parsed. Throws Stop, SceneError or render::Error, or
/// returns its code. `commandLine`: as a shell takes it.
using Run = std::function<Exit(const std::string& commandLine)>;

struct Command {
    const char* name;
    const char* purpose;
    const char* examples[3];
    Run (*add)(CLI::App& app);  // adds its options, which the Run keeps
};

}  // namespace demos
