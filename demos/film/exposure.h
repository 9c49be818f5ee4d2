/// Single pictures of a player that advances by any number of steps: stills and strips.
#pragma once
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/snapshot/player.h"

namespace demos {

/// Advances by `steps`, to `time` (s). Returns what the open shutter saw, one frame per step.
std::vector<render::Frame> playTo(double time, int steps, const FilmPlan& plan, Player& player);

/// The picture of these frames, the last of which is at `time` (s): that of the film's frame.
render::Image exposed(const std::vector<render::Frame>& seen, double time, const FilmPlan& plan,
                      render::Renderer& renderer);

}  // namespace demos
