/// Where everything of a page of charts goes.
#pragma once
#include <string>
#include <vector>

#include "demos/charts/chart.h"
#include "demos/charts/ticks.h"

namespace demos {

/// True when the sample can be drawn: finite, and above 0 on a log axis.
bool isDrawable(const Chart& chart, const Series& series, std::size_t sample);

/// What stands at the ends of a chart's lines.
struct EndLabel {
    int series = -1;   // its number; -1: none, "+ 3 more"
    std::string text;  // as much as has room
    float value = 0;   // where it wants to be: pixels
    float y = 0;       // where it is, apart from the others: pixels, its middle
};

/// A line's name below a chart, behind a sample of it: where labels at the ends have no room.
struct LegendEntry {
    int series = 0;    // its number
    std::string text;  // as much as has room
    float x = 0;       // pixels from the page's margin
    int row = 0;       // from 0
};

/// One chart's place. Pixels.
struct Plot {
    float left = 0, right = 0, top = 0, bottom = 0;  // of the lines' area
    float titleBase = 0, yTitleBase = 0, tickBase = 0, xTitleBase = 0, legendBase = 0;
    Axis x, y;
    bool empty = false;               // no data
    std::vector<std::string> title;   // lines
    std::vector<std::string> yTitle;  // lines, with a note on what is left out
    std::vector<std::string> xTitle;  // lines
    bool xTitleBelow = false;         // the ticks; else it stands beside them
    bool numbered = false;            // names of x are in its title, numbers at its ticks
    float labelPixels = 0;            // height of the end labels
    std::vector<EndLabel> labels;
    std::vector<LegendEntry> legend;
    float higher = 0;  // for lines of text that a chart with short texts does not have

    float xOf(double value) const {
        return left + static_cast<float>(x.share(value)) * (right - left);
    }
    float yOf(double value) const {
        return bottom - static_cast<float>(y.share(value)) * (bottom - top);
    }
};

inline constexpr float kLineWidth = 2.6f;  // pixels of a line where Page::unit is 1

struct Page {
    float unit = 1.0f;                  // 1 in a picture 1280 pixels wide
    float text = 20.0f, title = 26.0f;  // pixels, whole
    bool onPaper = false;               // letters do not shrink; titles break into lines
    bool low = false;                   // on paper, but no room for rows below the ticks
    float leastLabel = 14.0f;           // pixels, whole: so far letters at the lines' ends shrink
    float margin = 18.0f;
    std::vector<Plot> plots;  // as many as charts; they share left and right
};

Page pageOf(const std::vector<Chart>& charts, PictureSize size, const Paper& paper = {});

}  // namespace demos
