/// Options that several commands take, for their `add`. With the commands and program/parse.cpp the
/// only place that knows the option parser.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>

#include "demos/commands/input_protection.h"
#include "demos/commands/option_checks.h"

namespace demos {

inline constexpr int kMostScenes = 1000;

/// What a command was asked for; its `add` binds the parser to it, and its Run keeps it.
template <class CommandOptions>
struct Asked {
    CommandOptions options;
    OptionTexts texts;
};

/// The options, with everything that commands share checked. Throws Stop (usage).
template <class CommandOptions>
CommandOptions& settled(Asked<CommandOptions>& asked, const std::string& commandLine) {
    checkOptions(asked.options, asked.texts);
    asked.options.commandLine = commandLine;
    spareScenes(asked.options.scenes, asked.options.outputs);
    spareScenes(asked.options.scenes, {asked.options.caption});
    return asked.options;
}

/// An option that may be given again, a value each time.
CLI::Option* takesAgain(CLI::Option* option);
/// An option of several values with commas.
CLI::Option* takesList(CLI::Option* option);
void addRenderer(CLI::App& app, Options& options);
void addJobs(CLI::App& app, Options& options);

/// The scene, and what changes its values.
void addSceneChoice(CLI::App& app, Options& options, OptionTexts& texts);
void addFeedback(CLI::App& app, Options& options);
void addPicture(CLI::App& app, Options& options, OptionTexts& texts);
/// A figure for a paper: its size there, and the caption beside it.
void addFigure(CLI::App& app, Options& options, OptionTexts& texts);
void addSeconds(CLI::App& app, Options& options);

}  // namespace demos
