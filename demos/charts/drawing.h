/// A picture of charts as primitives. Both SVG and pixels are made from it, so they cannot differ.
/// Positions are in pixels, y down.
#pragma once
#include <string>
#include <vector>

#include "demos/charts/chart.h"
#include "render/canvas.h"

namespace demos {

struct Rectangle {
    render::Point corner;
    float width = 0.0f, height = 0.0f;
    render::Color color;
};

/// All points are finite; a single point is a dot.
struct Line {
    std::vector<render::Point> points;
    float width = 1.0f;
    render::Color color;
};

struct Label {
    std::string text;  // one line of valid UTF-8
    render::Point at;  // its anchor, on the baseline
    render::Anchor anchor = render::Anchor::start;
    float pixels = 20.0f;  // a whole number; cap to descender
    render::Color color;
};

/// Drawn in this order: rectangles, lines, labels.
struct Drawing {
    PictureSize size;
    double millimetres = 0.0;     // width on paper; 0 = not known
    double pixelsPerPoint = 0.0;  // 0 = not known
    std::vector<Rectangle> rectangles;
    std::vector<Line> lines;
    std::vector<Label> labels;
};

Drawing drawingOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                  const Paper& paper = {});

std::string svgOf(const Drawing& drawing);      // chart_svg.cpp
render::Image imageOf(const Drawing& drawing);  // chart_image.cpp

}  // namespace demos
