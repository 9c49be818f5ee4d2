/// Parses the command line.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/text/stop.h"

namespace demos {

/// Returns what to run; nothing if help or the version was requested and has been printed.
/// Throws Stop (usage).
std::optional<std::function<Exit()>> parse(int argc, const char* const* argv);

/// A command's name and its options, for completion in a shell.
struct CommandWords {
    std::string name;
    std::vector<std::string> options;
};
std::vector<CommandWords> commandWords();

}  // namespace demos
