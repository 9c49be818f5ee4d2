#include "demos/film/plot_strip.h"

#include <cmath>

#include "demos/charts/layout.h"
#include "demos/measures/measures.h"
#include "demos/processes/signals.h"
#include "demos/text/stop.h"

namespace demos {

Chart playedChart(const SceneDescription& scene) {
    watchSignals();
    Stage stage(scene);
    Recorder recorder;
    recorder.look(stage);
    const long steps = std::lround(scene.seconds * scene.hz);
    for (long i = 0; i < steps && stage.step(); ++i) {
        if (interrupted())
            throw Stop(Exit::interrupted, "interrupted while measuring for the plot");
        recorder.look(stage);
    }
    Chart chart = recorder.charts({scene.look.plot}).back();  // residual: the one over time
    chart.title.clear();
    return chart;
}

void addStrip(const std::vector<Chart>& charts, FilmPlan& plan, const Paper& paper) {
    const PictureSize size{plan.layout.strip.width, plan.layout.strip.height};
    const std::string& theme = plan.panels.front().overlays.theme;
    plan.strip = imageOf(charts, size, theme, paper);
    const Page page = pageOf(charts, size, paper);
    plan.cursor = {page.plots[0].xOf(0.0), page.plots[0].xOf(plan.scene().seconds),
                   page.plots[0].top, page.plots[0].bottom};
}

}  // namespace demos
