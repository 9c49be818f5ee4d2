/// The options of impulse render, for it and for the job files that call it.
#pragma once
#include "demos/commands/shared_options.h"
#include "demos/film/film_options.h"

namespace demos {

void addRenderOptions(CLI::App& app, FilmOptions& options, OptionTexts& texts);

}  // namespace demos
