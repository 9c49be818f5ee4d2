/// Draws films, stills and strips of slides.
#pragma once
#include <filesystem>

#include "demos/film/progress.h"
#include "demos/slides/made_deck.h"
#include "demos/slides/slide_plan.h"

namespace demos {

/// The settings of all drawing.
struct Studio {
    int jobs = 0;           // maximum of drawing processes; 0: one per core
    Progress& progress;     // advances with every frame
    std::string& incident;  // set to what happened until the last frame (Composite::incident)
};

/// Writes the film to `file`, complete or not at all; with an empty `file` draws only the poster,
/// which otherwise comes from the same pass. Throws Stop (interrupted; diverged if a step
/// fails), render::Error.
MadeFilm madeFilm(const SlidePlan& plan, const std::filesystem::path& file, const Studio& studio);

/// A still, or a strip of all the plan's frames with their times. Throws the same.
MadePicture madeStill(const SlidePlan& plan, const Studio& studio);
MadePicture madeStrip(const SlidePlan& plan, const Studio& studio);

}  // namespace demos
