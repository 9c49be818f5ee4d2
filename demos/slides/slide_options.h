/// A slide's keys as options of the command that makes its picture.
#pragma once
#include <string>

#include "demos/slides/deck.h"
#include "demos/slides/loaded_runs.h"
#include "demos/slides/make_deck.h"

namespace demos {

/// Scene, settings, look and size; quiet. `making.options` gives jobs, samples, context and
/// reproducible.
Options optionsOf(const Slide& slide, const Deck& deck, const DeckMaking& making);

/// The whole slide, or two thirds of it next to words, charts or tables; even sides. One film or
/// still beside words is 4:3, as its column is.
PictureSize pictureSize(const Slide& slide, PictureSize whole);

/// The columns of a strip whose moments have the shape of `whole`.
int stripColumns(const Slide& slide, PictureSize whole);

/// "impulse still stack -t 2.9 --show impulses --theme print"; empty if nothing is drawn. A shell
/// comment after it says what no option can: which part of a film, and how fast.
std::string commandOf(const Slide& slide, const Deck& deck, const LoadedRuns& loaded);

}  // namespace demos
