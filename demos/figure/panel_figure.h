/// Runs of one scene under several settings at one moment: pictures with (a), (b), ... below them,
/// and a chart over the whole width.
#pragma once
#include <string>
#include <vector>

#include "demos/charts/chart.h"
#include "demos/comparisons/runs_options.h"
#include "demos/figure/figure_grid.h"
#include "demos/figure/picture_facts.h"
#include "demos/film/variants.h"

namespace demos {

/// Decided before anything is simulated.
struct PanelFigure {
    std::vector<FilmPlan> plans;  // one per run
    std::vector<std::vector<std::string>> labels;
    StripLayout layout;
    PictureSize chart;  // below; height 0 = none
    double time = 0.0;  // s
    int height = 0;     // pixels, of the whole
    Paper paper;
};

/// `columns`: 0 = as many as there is room for. Throws Stop (usage, environment) if the figure is
/// not possible.
PanelFigure planPanels(const std::vector<Variant>& runs, int columns, bool chart,
                       const RunsOptions& options);

struct DrawnPanels {
    render::Image image;
    std::vector<PictureFacts> facts;    // one per run
    std::vector<std::string> diverged;  // likewise: an incident, or the step that failed; or empty
};
/// Throws Stop (interrupted), render::Error. A run with an incident is marked; one whose step fails
/// is shown in its last good state.
DrawnPanels drawPanels(const PanelFigure& figure, const std::vector<Chart>& charts);

}  // namespace demos
