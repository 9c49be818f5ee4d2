/// A slide's wishes as the options of the command that would fulfil them.
#pragma once
#include <string>

#include "demos/slides/deck.h"
#include "demos/slides/loaded_runs.h"
#include "demos/slides/make_deck.h"

namespace demos {

/// Scene, settings, look and size; never says anything. `making.options` gives jobs, samples,
/// context and reproducible.
Options optionsOf(const Slide& slide, const Deck& deck, const DeckMaking& making);

/// The whole slide, or two thirds of it where words, charts or tables stand beside; even sides.
PictureSize pictureSize(const Slide& slide, PictureSize whole);

/// Of a strip, whose moments have the shape of `whole`.
int stripColumns(const Slide& slide, PictureSize whole);

/// "impulse still stack -t 2.9 --show impulses --theme print"; empty where nothing is drawn. What
/// no option says follows as a shell's comment: which part of a film, and how fast.
std::string commandOf(const Slide& slide, const Deck& deck, const LoadedRuns& loaded);

}  // namespace demos
