/// Simulates a scene, draws it and writes the film.
#pragma once
#include "demos/film/film_options.h"
#include "demos/film/film_plan.h"

namespace demos {

/// Checks a plan before anything is simulated: throws Stop and render::Error for outputs that it
/// cannot write and for pictures that need more memory than there is.
void checkFilmPlan(const FilmPlan& plan, const FilmOptions& options);

/// Throws Stop and render::Error; files written until then stay and are complete. A body that could
/// not continue as it was is reported when all is written, as Stop (diverged).
void makeFilm(FilmPlan plan, const FilmOptions& options);

}  // namespace demos
