/// Options that several commands share, for their `add`. Only this file, the commands and program/
/// know the option parser.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>

#include "demos/commands/input_protection.h"
#include "demos/commands/option_checks.h"

namespace demos {

inline constexpr int kMostScenes = 1000;

/// The values of a command's options: its `add` binds the parser to them, its Run owns them.
template <class CommandOptions>
struct Asked {
    CommandOptions options;
    OptionTexts texts;
};

/// The options, after the checks that all commands share. Throws Stop (usage).
template <class CommandOptions>
CommandOptions& settled(Asked<CommandOptions>& asked, const std::string& commandLine) {
    checkOptions(asked.options, asked.texts);
    asked.options.commandLine = commandLine;
    spareScenes(asked.options.scenes, asked.options.outputs);
    spareScenes(asked.options.scenes, {asked.options.caption});
    return asked.options;
}

/// Makes an option repeatable, with one value each time.
CLI::Option* takesAgain(CLI::Option* option);
/// Makes an option take several values, separated by commas.
CLI::Option* takesList(CLI::Option* option);
void addRenderer(CLI::App& app, Options& options);
/// --whole-frames, of commands that draw films.
void addWholeFrames(CLI::App& app, Options& options);
void addJobs(CLI::App& app, Options& options);

/// The scene, and the options that change its values.
void addSceneChoice(CLI::App& app, Options& options, OptionTexts& texts);
void addFeedback(CLI::App& app, Options& options);
void addPicture(CLI::App& app, Options& options, OptionTexts& texts);
/// Those of a picture that need the memory of all steps: --show and --colour-by.
void addMemory(CLI::App& app, Options& options, OptionTexts& texts);
/// A figure for a paper: its size on paper, and its caption.
void addFigure(CLI::App& app, Options& options, OptionTexts& texts);
void addSeconds(CLI::App& app, Options& options);

}  // namespace demos
