/// One command of the program: its name, its purpose, its options and the function that runs it.
#pragma once
#include <functional>
#include <string>

#include "demos/text/stop.h"

namespace CLI {
class App;
}

namespace demos {

/// Runs a command after its options were parsed. Returns the exit code, or throws Stop, SceneError
/// or render::Error. `commandLine` is quoted for a shell.
using Run = std::function<Exit(const std::string& commandLine)>;

struct Command {
    const char* name;
    const char* purpose;
    const char* examples[3];
    Run (*add)(CLI::App& app);  // adds its options; the Run owns them
};

}  // namespace demos
