/// The texts of a chart, broken into lines: titles, the x axis's names, the legend below.
#pragma once
#include <string>
#include <vector>

#include "demos/charts/layout.h"

namespace demos {

inline constexpr float kRow = 1.25f;  // distance of lines of one text, times their height

/// Labels of the lines with data; their positions are not set.
std::vector<EndLabel> labelsOf(const Chart& chart);

/// The index of the last sample that can be drawn; -1: none.
int lastDrawn(const Chart& chart, const Series& series);

/// Sets titles and legend, and the plot's additional height for them. `note`: added to the y axis's
/// title. `width`: of the page, pixels.
void setTexts(const Chart& chart, const std::string& note, const Page& page, float width,
              Plot& plot);

}  // namespace demos
