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

inline constexpr const char* kProgramPurpose =
    "sequential-impulse rigid bodies, filmed without a display";

/// What --help says, for completion in a shell and the manual page.
struct OptionWords {
    std::vector<std::string> names;  // "-o", "--output"; none: an argument without a name
    std::string value;               // "FILE"; empty: it takes none
    std::string text;
};
struct CommandWords {
    std::string name, purpose;
    std::vector<std::string> examples;
    std::vector<OptionWords> options;
};
std::vector<CommandWords> commandWords();

/// The options without a command, such as --version.
std::vector<OptionWords> programOptions();

/// The last lines of the program's --help.
std::string closingWords();

}  // namespace demos
