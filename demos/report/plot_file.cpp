#include "demos/report/plot_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <span>

#include "demos/commands/table.h"
#include "demos/scene/complaints.h"
#include "demos/stop.h"
#include "render/encode/file.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr double kMostPixels = 64e6;  // of a PNG: 256 MB, and as much again while it is packed

std::vector<Chart> chartsOf(const Recorder& recorder, const PlotChoice& choice) {
    if (!choice.what.empty()) return recorder.charts(choice.what);
    std::vector<Chart> charts =
        recorder.charts({"energy", "penetration", "separation", "residual"});
    std::erase_if(charts, [](const Chart& chart) { return !hasData(chart); });
    return charts;
}

}  // namespace

PlotChoice plotChoiceOf(const Options& options, const SceneDescription& scene) {
    const std::string theme = options.theme.empty() ? scene.look.theme : options.theme;
    return {options.what, options.size, theme.empty() ? "studio" : theme};
}

void checkChartFile(const std::string& file) {
    if (!file.ends_with(".png") && !file.ends_with(".svg"))
        throw Stop(Exit::usage,
                   fmt::format("plot '{}': unknown ending; use .svg or .png", printable(file)));
    render::checkReplaceable(file);
}

void writeCharts(const std::string& file, const std::vector<Chart>& charts, PictureSize size,
                 const std::string& theme) {
    if (file.ends_with(".png")) {
        writeResult(file, render::encodePng(imageOf(charts, size, theme)));
        return;
    }
    const std::string svg = svgOf(charts, size, theme);
    writeResult(file, {reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size()});
}

void checkPlotFile(const std::string& file, const PlotChoice& choice) {
    if (file.ends_with(".png") && choice.size &&
        static_cast<double>(choice.size->width) * choice.size->height > kMostPixels)
        throw Stop(Exit::usage,
                   fmt::format("--size {}x{}: a .png plot has at most {:.0f} million pixels; an "
                               ".svg has no such limit",
                               choice.size->width, choice.size->height, kMostPixels / 1e6));
    checkChartFile(file);
}

std::size_t writePlot(const std::string& file, const Recorder& recorder, const PlotChoice& choice) {
    const std::vector<Chart> charts = chartsOf(recorder, choice);
    writeCharts(file, charts, choice.size.value_or(chartSize(charts.size())), choice.theme);
    return charts.size();
}

}  // namespace demos
