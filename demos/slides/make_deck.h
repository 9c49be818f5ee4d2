/// Simulates and draws what a deck needs.
#pragma once
#include <filesystem>

#include "demos/film/progress.h"
#include "demos/options/options.h"
#include "demos/slides/made_deck.h"

namespace demos {

/// Settings that are the same for all slides.
struct DeckMaking {
    std::filesystem::path folder;  // an existing folder for films, <id>.mp4
    bool films = true;             // false: only posters, as for paper
    Options options;               // jobs, samples, reproducible, context, quiet, json
};

/// `deck` has been checked by its reader. Throws Stop (interrupted; diverged if a step fails),
/// render::Error.
/// Without ffmpeg posters replace films, with a note; notes are printed before anything is
/// simulated.
MadeDeck makeDeck(const Deck& deck, const DeckMaking& making);

/// "; to make the deck again: impulse slides ...", after an interruption; empty if `options` do not
/// come from a command line.
std::string againLine(const Options& options);

}  // namespace demos
