/// Plays and draws what a deck asks for.
#pragma once
#include <filesystem>

#include "demos/film/progress.h"
#include "demos/options/options.h"
#include "demos/slides/made_deck.h"

namespace demos {

/// Everything about the making that is the same for all slides.
struct DeckMaking {
    std::filesystem::path folder;  // is there; films go to it as <id>.mp4
    bool films = true;             // false: posters alone, as for paper
    Options options;               // jobs, samples, reproducible, context, quiet, json
};

/// `deck` has been read, so that what it names is there. Throws Stop (diverged, interrupted),
/// render::Error. Without ffmpeg there are posters in place of films, and a remark; remarks are
/// said before anything is played.
MadeDeck makeDeck(const Deck& deck, const DeckMaking& making);

/// "; to make the deck again: impulse slides ...", after an interruption; empty where `options`
/// come from no command line.
std::string againLine(const Options& options);

}  // namespace demos
