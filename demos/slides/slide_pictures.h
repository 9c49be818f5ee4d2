/// Films, stills and strips of slides, drawn.
#pragma once
#include <filesystem>

#include "demos/film/progress.h"
#include "demos/slides/made_deck.h"
#include "demos/slides/slide_plan.h"

namespace demos {

/// With what everything is drawn.
struct Studio {
    int jobs = 0;        // drawing processes at most; 0: one a core
    Progress& progress;  // advances a frame a frame
};

/// Where the plan has all frames of a film they go to `file`, whole or not at all; the poster comes
/// from the same pass. Throws Stop (diverged, interrupted), render::Error.
MadeFilm madeFilm(const SlidePlan& plan, const std::filesystem::path& file, const Studio& studio);

/// A still, or a strip of all the plan's frames with their times. Throws likewise.
MadePicture madeStill(const SlidePlan& plan, const Studio& studio);
MadePicture madeStrip(const SlidePlan& plan, const Studio& studio);

}  // namespace demos
