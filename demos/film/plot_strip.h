/// The plot below the pictures of a film, with a cursor that follows the time.
#pragma once
#include <vector>

#include "demos/charts/chart.h"
#include "demos/film/film_plan.h"

namespace demos {

/// Simulates the scene once, without drawing, for the chart that its look.plot names. Ends early if
/// the scene diverges. Throws Stop (interrupted) on a signal.
Chart playedChart(const SceneDescription& scene);

/// The plan must have room for the strip, and the charts' x axis must be time.
void addStrip(const std::vector<Chart>& charts, FilmPlan& plan, const Paper& paper = {});

}  // namespace demos
