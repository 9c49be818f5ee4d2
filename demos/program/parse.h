/// The command line, parsed.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/text/stop.h"

namespace demos {

/// What is to be done; nothing when help or the version was asked for and has been printed.
/// Throws Stop (usage).
std::optional<std::function<Exit()>> parse(int argc, const char* const* argv);

/// A command's name and what may follow it, for shells to complete.
struct CommandWords {
    std::string name;
    std::vector<std::string> options;
};
std::vector<CommandWords> commandWords();

}  // namespace demos
