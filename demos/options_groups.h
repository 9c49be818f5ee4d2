/// Options that several commands take.
#pragma once
#include "demos/options_commands.h"

namespace demos {

inline constexpr int kMostScenes = 1000;

/// An option that may be given again, a value each time.
CLI::Option* takesAgain(CLI::Option* option);
/// An option of several values with commas.
CLI::Option* takesList(CLI::Option* option);
void addRenderer(CLI::App& app, Options& options);
void addJobs(CLI::App& app, Options& options);

/// The scene, and what changes its values.
void addSceneChoice(CLI::App& app, Options& options, RawOptions& raw);
void addFeedback(CLI::App& app, Options& options);
void addPicture(CLI::App& app, Options& options, RawOptions& raw);
/// A figure for a paper: its size there, and the caption beside it.
void addFigure(CLI::App& app, Options& options, RawOptions& raw);
void addSeconds(CLI::App& app, Options& options);
/// What a film is made for: a limit of a page or a chat, a picture to show before it plays.
void addDelivery(CLI::App& app, Options& options, RawOptions& raw);

}  // namespace demos
