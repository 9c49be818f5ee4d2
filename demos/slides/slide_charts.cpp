#include "demos/slides/slide_charts.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/look/type.h"
#include "demos/slides/slide_arrangement.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr double kFiner = 1.5;  // pixels of a chart per pixel of a slide of 1280x720

/// The description for people who cannot see it.
std::string saysOf(const Chart& chart) {
    const std::string what = chart.title.empty() ? chart.yTitle : chart.title;
    std::vector<std::string> labels;
    for (const Series& series : chart.series)
        if (!series.label.empty()) labels.push_back(series.label);
    const std::string lines = labels.empty() ? "" : fmt::format(": {}", fmt::join(labels, ", "));
    return fmt::format("Chart of {} over {}{}", what, chart.xTitle, lines);
}

/// The factor on the letters of a chart for a screen, whose unit is a picture of 1280x240.
double typeFor(PictureSize size) {
    constexpr double kLetterPixels = 20.0;  // there, from cap to descender
    const double unit = std::min(size.width / 1280.0, size.height / 240.0);
    return kFiner * kLeastLetters / kEmShare / (kLetterPixels * unit);
}

}  // namespace

std::vector<Chart> chartsOf(const Slide& slide, const LoadedRuns& loaded, const Recorder& recorder,
                            const std::vector<Measured>& runs) {
    if (!loaded.several) return recorder.charts(slide.plots);
    std::vector<Chart> charts;
    for (const std::string& name : slide.plots) {
        const int measure = measureCalled(name);
        if (measure < 0) continue;  // the reader refuses unknown names
        charts.push_back(loaded.isSweep() ? sweepChart(runs, measure, loaded.key)
                                          : historyChart(runs, measure, ""));
    }
    return charts;
}

MadePicture chartPicture(const Chart& chart, const SlideRoom& room, const std::string& theme) {
    MadePicture picture;
    picture.size = {static_cast<int>(kFiner * room.width), static_cast<int>(kFiner * room.height)};
    const Paper paper{.type = typeFor(picture.size)};
    picture.png = render::encodePng(imageOf({chart}, picture.size, theme, paper));
    picture.svg = svgOf({chart}, picture.size, theme, paper);
    picture.says = saysOf(chart);
    return picture;
}

}  // namespace demos
