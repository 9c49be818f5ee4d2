/// Plays and draws what a deck asks for.
#pragma once
#include <filesystem>

#include "demos/film/progress.h"
#include "demos/options.h"
#include "demos/slides/made_deck.h"

namespace demos {

/// Everything about the making that is the same for all slides.
struct DeckMaking {
    std::filesystem::path folder;  // is there; films go to it as <id>.mp4
    bool films = true;             // false: posters alone, as for paper
    Options options;               // jobs, reproducible, context, samples, quiet, json
};

/// `deck` has been read, so that what it names is there. Throws Stop (diverged, interrupted),
/// render::Error. Without ffmpeg there are posters in place of films, and a remark.
MadeDeck makeDeck(const Deck& deck, const DeckMaking& making);

}  // namespace demos
