/// The layout of a page of charts.
#pragma once
#include <string>
#include <vector>

#include "demos/charts/chart.h"
#include "demos/charts/ticks.h"

namespace demos {

/// True if the sample can be drawn: finite, and above 0 on a log axis.
bool isDrawable(const Chart& chart, const Series& series, std::size_t sample);

/// A label at the end of a chart's line.
struct EndLabel {
    int series = -1;   // its number; -1: none, for "+ 3 more"
    std::string text;  // as much as fits
    float value = 0;   // the wanted position: pixels
    float y = 0;       // the position of its middle, apart from the others: pixels
};

/// The name of a line below a chart, after a sample of the line, if end labels have no room.
struct LegendEntry {
    int series = 0;    // its number
    std::string text;  // as much as fits
    float x = 0;       // pixels from the page's margin
    int row = 0;       // from 0
};

/// The layout of one chart, in pixels.
struct Plot {
    float left = 0, right = 0, top = 0, bottom = 0;  // of the lines' area
    float titleBase = 0, yTitleBase = 0, tickBase = 0, xTitleBase = 0, legendBase = 0;
    Axis x, y;
    bool empty = false;               // no data
    std::vector<std::string> title;   // lines
    std::vector<std::string> yTitle;  // lines, with a note on values left out
    std::vector<std::string> xTitle;  // lines
    bool xTitleBelow = false;         // below the ticks; else next to them
    bool numbered = false;            // names of x are in the title, numbers at the ticks
    float labelPixels = 0;            // height of the end labels
    std::vector<EndLabel> labels;
    std::vector<LegendEntry> legend;
    float higher = 0;  // additional height for more lines of text

    float xOf(double value) const {
        return left + static_cast<float>(x.share(value)) * (right - left);
    }
    float yOf(double value) const {
        return bottom - static_cast<float>(y.share(value)) * (bottom - top);
    }
};

inline constexpr float kLineWidth = 2.6f;  // pixels of a line if Page::unit is 1

struct Page {
    float unit = 1.0f;                  // 1 in a picture 1280 pixels wide
    float text = 20.0f, title = 26.0f;  // pixels, whole
    bool onPaper = false;               // letters do not shrink; titles break into lines
    bool low = false;                   // on paper, but without room for rows below the ticks
    float leastLabel = 14.0f;           // pixels, whole: the least size of end labels
    float margin = 18.0f;
    std::vector<Plot> plots;  // one per chart, with the same left and right
};

Page pageOf(const std::vector<Chart>& charts, PictureSize size, const Paper& paper = {});

}  // namespace demos
