/// The plot below the pictures of a film, with a cursor that goes with the time.
#pragma once
#include <vector>

#include "demos/charts/chart.h"
#include "demos/film/film_plan.h"

namespace demos {

/// Plays the scene once, physics only, for the chart that its look.plot names. Ends early where the
/// scene diverges. Throws Stop (interrupted) on a signal.
Chart playedChart(const SceneDescription& scene);

/// The plan has room for it. The charts' x axis is the time.
void addStrip(const std::vector<Chart>& charts, FilmPlan& plan, const Paper& paper = {});

}  // namespace demos
