/// Charts of a slide's runs, to be read from the back of a room.
#pragma once
#include <string>
#include <vector>

#include "demos/report/measure_table.h"
#include "demos/report/measures.h"
#include "demos/slides/cast.h"
#include "demos/slides/made_deck.h"

namespace demos {

/// Half a slide, in pixels; type and lines are so many times those of a chart on paper.
constexpr PictureSize kSlideChart{860, 540};
inline constexpr Paper kSlideChartPaper{.type = 1.8};

/// One run: `recorder` has seen it. Several: a line a run, or over the values of a sweep.
std::vector<Chart> chartsOf(const Slide& slide, const Cast& cast, const Recorder& recorder,
                            const std::vector<Measured>& runs);

/// As SVG and PNG.
MadePicture chartPicture(const Chart& chart, const std::string& theme);

}  // namespace demos
