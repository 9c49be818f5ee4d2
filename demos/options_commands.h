/// What every command takes. With options.cpp the only place that knows the option parser.
#pragma once
#include <CLI/CLI.hpp>
#include <span>

#include "demos/options.h"
#include "demos/options_check.h"

namespace demos {

struct CommandText {
    Command command;
    const char* name;
    const char* purpose;
    const char* examples[3];
};

/// Every command, in the order of the help page.
std::span<const CommandText> commandTexts();

/// Binds a command's options.
void addOptions(Command command, CLI::App& app, Options& options, RawOptions& raw);

}  // namespace demos
