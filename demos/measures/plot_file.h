/// Charts of a run as files.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demos/measures/measures.h"
#include "demos/options/options.h"

namespace demos {

/// Which charts, and how they look.
struct PlotChoice {
    std::vector<std::string>
        what;  // of measureNames(); empty: the most informative ones with data
    std::optional<PictureSize> size;  // empty: 1280 pixels wide, as high as the charts need
    std::string theme;                // of themeNames()
    Paper paper;
};
/// `what`: of measureNames(), or none.
PlotChoice plotChoiceOf(const Options& options, const std::vector<std::string>& what,
                        const SceneDescription& scene);

/// Throws Stop (usage) unless the name ends in .svg or .png, and render::Error if it exists but is
/// not an ordinary file.
void checkChartFile(const std::string& file);

/// The content of the file, by its extension. Throws Stop (usage) if a .png would be too large.
std::vector<std::uint8_t> chartBytes(const std::string& file, const std::vector<Chart>& charts,
                                     PictureSize size, const std::string& theme,
                                     const Paper& paper = {});

/// Writes the file completely or not at all; its folder is created. Throws render::Error.
void writeCharts(const std::string& file, const std::vector<Chart>& charts, PictureSize size,
                 const std::string& theme);

/// To be called before the simulation. Throws Stop (usage) unless the name ends in .svg or .png,
/// and render::Error if it exists but is not an ordinary file.
void checkPlotFile(const std::string& file, const PlotChoice& choice);

/// The chosen charts, and the size of their page.
std::vector<Chart> chartsOf(const Recorder& recorder, const PlotChoice& choice);
PictureSize sizeOf(const std::vector<Chart>& charts, const PlotChoice& choice);

/// Writes the file completely or not at all; its folder is created. Returns the number of charts.
/// Throws render::Error.
std::size_t writePlot(const std::string& file, const Recorder& recorder, const PlotChoice& choice);

}  // namespace demos
