/// A scene's sections as the chapters of its film.
#pragma once
#include <vector>

#include "demos/film/film_plan.h"
#include "render/encode/chapters.h"

namespace demos {

/// `chosen`: which of the plan's frames the film has. A chapter has its section's name, else its
/// caption, else a number; what comes before the first section is a chapter with the scene's title.
/// None without sections.
std::vector<render::Chapter> chaptersOf(const FilmPlan& plan, const std::vector<bool>& chosen);

}  // namespace demos
