#include "demos/measures/plot_file.h"
#include "demos/options/picture_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "demos/text/table.h"
#include "render/encode/file.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr double kMostPixels = 64e6;  // of a PNG: 256 MB, and twice that while it is compressed

/// All pixels of a .png are kept in memory.
void checkPixels(const std::string& file, PictureSize size, const Paper& paper) {
    if (!file.ends_with(".png") || static_cast<double>(size.width) * size.height <= kMostPixels)
        return;
    throw Stop(Exit::usage,
               fmt::format("{} {}x{}: a .png plot has at most {:.0f} million pixels; an .svg has no "
                           "such limit",
                           paper.given() ? "--width and --dpi make" : "--size", size.width,
                           size.height, kMostPixels / 1e6));
}

}  // namespace

std::vector<Chart> chartsOf(const Recorder& recorder, const PlotChoice& choice) {
    if (!choice.what.empty()) return recorder.charts(choice.what);
    std::vector<Chart> charts =
        recorder.charts({"energy", "penetration", "separation", "residual"});
    std::erase_if(charts, [](const Chart& chart) { return !hasData(chart); });
    return charts;
}

PictureSize sizeOf(const std::vector<Chart>& charts, const PlotChoice& choice) {
    if (choice.paper.given()) return chartSize(charts, choice.paper, choice.size);
    return choice.size.value_or(chartSize(charts.size()));
}

PlotChoice plotChoiceOf(const Options& options, const std::vector<std::string>& what,
                        const SceneDescription& scene) {
    return {what, options.size, themeOf(scene, options), paperOf(options)};
}

void checkChartFile(const std::string& file) {
    if (!file.ends_with(".png") && !file.ends_with(".svg"))
        throw Stop(Exit::usage,
                   fmt::format("plot '{}': unknown file extension; use .svg or .png", printable(file)));
    render::checkReplaceable(file);
}

std::vector<std::uint8_t> chartBytes(const std::string& file, const std::vector<Chart>& charts,
                                     PictureSize size, const std::string& theme,
                                     const Paper& paper) {
    checkPixels(file, size, paper);
    if (file.ends_with(".png"))
        return render::encodePng(imageOf(charts, size, theme, paper),
                                 paper.given() ? paper.dpi : 0);
    const std::string svg = svgOf(charts, size, theme, paper);
    return {svg.begin(), svg.end()};
}

void writeCharts(const std::string& file, const std::vector<Chart>& charts, PictureSize size,
                 const std::string& theme) {
    writeResult(file, chartBytes(file, charts, size, theme));
}

void checkPlotFile(const std::string& file, const PlotChoice& choice) {
    const std::vector<Chart> least(std::max<std::size_t>(choice.what.size(), 1));
    checkPixels(file, sizeOf(least, choice), choice.paper);
    checkChartFile(file);
}

std::size_t writePlot(const std::string& file, const Recorder& recorder, const PlotChoice& choice) {
    const std::vector<Chart> charts = chartsOf(recorder, choice);
    writeCharts(file, charts, sizeOf(charts, choice), choice.theme);
    return charts.size();
}

}  // namespace demos
