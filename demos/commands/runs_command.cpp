#include "demos/commands/runs_command.h"

#include "demos/measures/summary.h"

namespace demos {

void addRuns(CLI::App& app, RunsOptions& options, OptionTexts& texts) {
    addSceneChoice(app, options, texts);
    addSeconds(app, options);
    addPicture(app, options, texts);
    addFigure(app, options, texts);
    app.add_option("-t,--time", options.time,
                   "with --width: time of the figure in s; default: the end")
        ->type_name("S");
    addJobs(app, options);
    app.add_option("--measure", options.measure,
                   "the measure to plot: drift speed penetration separation energy residual "
                   "sweeps ms; "
                   "default: the most telling")
        ->type_name("NAME");
    addFeedback(app, options);
}

void checkRuns(const RunsOptions& options) {
    checkTime("--time", options.time);
    if (!options.measure.empty() && measureCalled(options.measure) < 0)
        checkName("--measure", options.measure, measureWords());
    spareScenes(options.scenes, {options.plot});
}

}  // namespace demos
