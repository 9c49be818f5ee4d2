#include "demos/slides/slide_charts.h"

#include <fmt/format.h>

#include "render/encode/png.h"

namespace demos {
namespace {

/// For who cannot see it.
std::string saysOf(const Chart& chart) {
    const std::string what = chart.title.empty() ? chart.yTitle : chart.title;
    std::vector<std::string> labels;
    for (const Series& series : chart.series)
        if (!series.label.empty()) labels.push_back(series.label);
    const std::string lines = labels.empty() ? "" : fmt::format(": {}", fmt::join(labels, ", "));
    return fmt::format("Chart of {} over {}{}", what, chart.xTitle, lines);
}

}  // namespace

std::vector<Chart> chartsOf(const Slide& slide, const Cast& cast, const Recorder& recorder,
                            const std::vector<Measured>& runs) {
    if (!cast.several) return recorder.charts(slide.plots);
    std::vector<Chart> charts;
    for (const std::string& name : slide.plots) {
        const int measure = measureCalled(name);
        if (measure < 0) continue;  // the reader lets none through
        charts.push_back(cast.isSweep() ? sweepChart(runs, measure, cast.key)
                                        : historyChart(runs, measure, ""));
    }
    return charts;
}

MadePicture chartPicture(const Chart& chart, const std::string& theme) {
    MadePicture picture;
    picture.size = kSlideChart;
    picture.png = render::encodePng(imageOf({chart}, kSlideChart, theme, kSlideChartPaper));
    picture.svg = svgOf({chart}, kSlideChart, theme, kSlideChartPaper);
    picture.says = saysOf(chart);
    return picture;
}

}  // namespace demos
