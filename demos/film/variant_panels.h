/// Variants of a scene as the panels of a film.
#pragma once
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/film/variants.h"

namespace demos {

/// One panel per variant, with its label instead of the scene's title and captions.
std::vector<Panel> panelsOf(const std::vector<Variant>& variants);

}  // namespace demos
