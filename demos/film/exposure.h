/// One picture of a player that goes on by itself, not frame by frame: stills and strips.
#pragma once
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/snapshot/player.h"

namespace demos {

/// Plays `steps` further, to `time` (s); what the shutter saw on the way, a frame a step.
std::vector<render::Frame> playTo(double time, int steps, const FilmPlan& plan, Player& player);

/// The picture of that.
render::Image exposed(const std::vector<render::Frame>& seen, const FilmPlan& plan,
                      render::Renderer& renderer);

}  // namespace demos
