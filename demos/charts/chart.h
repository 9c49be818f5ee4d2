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
    std::vector<double> x, y;  // of one length; what is not finite is a gap
    int ink = -1;              // number of its colour; -1: its place among the lines
};

struct Chart {
    std::string title;
    std::string xTitle, xUnit;  // "time", "s" is shown as "time (s)"
    std::string yTitle, yUnit;
    bool logY = false;  // decades; what is not above 0 is left out, and said so
    std::vector<Series> series;
    bool logX = false;  // all x above 0; ticks at the values themselves
    double leastY = 0.0;  // of a log axis: what is below is left out, and said so
    std::vector<std::string> xNames = {};  // of x = 0, 1, ...: words, which no line joins
};

/// From mm to µm, nm or pm where all values are so small that mm would need powers of ten.
void useSmallUnit(Chart& chart);

/// False when there is nothing to draw; the chart's picture says "no data".
bool hasData(const Chart& chart);

/// Room for charts below each other that read from the back of a room.
PictureSize chartSize(std::size_t count);

/// The same for paper, high enough for its type; `ratio`: of the whole page, where one is asked
/// for. Throws Stop (usage) where there is no room for letters.
PictureSize chartSize(std::size_t count, const Paper& paper, std::optional<PictureSize> ratio);

/// The same for these charts, higher where their titles and legends take more lines.
PictureSize chartSize(const std::vector<Chart>& charts, const Paper& paper,
                      std::optional<PictureSize> ratio);

/// Of one chart below pictures.
PictureSize chartBelow(const Paper& paper);

/// The charts below each other, sharing the width. `theme`: one of themeNames(); transparent ones
/// have no ground. `paper`: decides about type and lines; those for a screen go by the size.
std::string svgOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                  const Paper& paper = {});
render::Image imageOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                      const Paper& paper = {});

}  // namespace demos
