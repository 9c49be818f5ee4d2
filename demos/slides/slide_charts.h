/// Charts of a slide's runs, readable from the back of a room.
#pragma once
#include <string>
#include <vector>

#include "demos/comparisons/measure_table.h"
#include "demos/measures/measures.h"
#include "demos/slides/loaded_runs.h"
#include "demos/slides/made_deck.h"
#include "demos/slides/slide_grid.h"

namespace demos {

/// One run: the charts of `recorder`. Several: a line per run, or over the values of a sweep.
std::vector<Chart> chartsOf(const Slide& slide, const LoadedRuns& loaded, const Recorder& recorder,
                            const std::vector<Measured>& runs);

/// As SVG and PNG, with the shape of its place on the slide and letters that are readable there.
MadePicture chartPicture(const Chart& chart, const SlideRoom& room, const std::string& theme);

}  // namespace demos
