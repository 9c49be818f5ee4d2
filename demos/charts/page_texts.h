/// The texts of a chart in lines: titles, the x axis's names, the legend below.
#pragma once
#include <string>
#include <vector>

#include "demos/charts/layout.h"

namespace demos {

inline constexpr float kRow = 1.25f;  // of lines of one text, in their height

/// Labels of the lines that have data; their values are not set.
std::vector<EndLabel> labelsOf(const Chart& chart);

/// Number of the last sample that can be drawn; -1: none.
int lastDrawn(const Chart& chart, const Series& series);

/// Sets titles and legend, and how much higher they make the plot. `note`: behind the y axis's
/// title; `width`: of the page, pixels.
void setTexts(const Chart& chart, const std::string& note, const Page& page, float width,
              Plot& plot);

}  // namespace demos
