/// Line charts as plain data, and as pictures: SVG for slides and papers, pixels for PNG.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/look/paper.h"
#include "render/image.h"

namespace demos {

struct Series {
    std::string label;         // at the line's end; empty = none
    std::vector<double> x, y;  // of equal length; a value that is not finite is a gap
    int ink = -1;              // number of its colour; -1: its index among the lines
};

struct Chart {
    std::string title;
    std::string xTitle, xUnit;  // "time", "s" is shown as "time (s)"
    std::string yTitle, yUnit;
    bool logY = false;  // decades; values not above 0 are left out, with a note
    std::vector<Series> series;
    bool logX = false;  // all x above 0; ticks at the values themselves
    double leastY = 0.0;  // of a log axis: smaller values are left out, with a note
    std::vector<std::string> xNames = {};  // words for x = 0, 1, ...; no line joins the points
};

/// Changes mm to the unit that fits the largest value (fitting_unit.h).
void useFittingUnit(Chart& chart);

/// False if there is nothing to draw; the chart's picture then says "no data".
bool hasData(const Chart& chart);

/// The size of a page of charts below each other, legible from the back of a room.
PictureSize chartSize(std::size_t count);

/// The same for paper, high enough for its type. `ratio`: of the whole page, if requested. Throws
/// Stop (usage) if there is no room for letters.
PictureSize chartSize(std::size_t count, const Paper& paper, std::optional<PictureSize> ratio);

/// The same for these charts: higher if their titles and legends take more lines.
PictureSize chartSize(const std::vector<Chart>& charts, const Paper& paper,
                      std::optional<PictureSize> ratio);

/// The size of one chart below pictures.
PictureSize chartBelow(const Paper& paper);

/// The charts below each other, all of the same width. `theme`: one of themeNames(); transparent
/// charts have no background. `paper`: decides the type and lines; on a screen the size does.
std::string svgOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                  const Paper& paper = {});
render::Image imageOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                      const Paper& paper = {});

}  // namespace demos
