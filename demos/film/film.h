/// Plays a scene, draws it and writes it.
#pragma once
#include "demos/film/film_plan.h"

namespace demos {

/// Throws Stop and render::Error; what has been written until then stays, whole.
void makeFilm(const FilmPlan& plan, const Options& options);

}  // namespace demos
