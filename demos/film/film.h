/// Plays a scene, draws it and writes it.
#pragma once
#include "demos/film/film_options.h"
#include "demos/film/film_plan.h"

namespace demos {

/// Refuses, with Stop, outputs that cannot be written and pictures that need more memory than there
/// is: before anything is played for them.
void checkFilmPlan(const FilmPlan& plan, const FilmOptions& options);

/// Throws Stop and render::Error; what has been written until then stays, whole.
void makeFilm(const FilmPlan& plan, const FilmOptions& options);

}  // namespace demos
