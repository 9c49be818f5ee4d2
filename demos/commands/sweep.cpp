#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "demos/commands/commands.h"
#include "demos/commands/input_protection.h"
#include "demos/commands/runs_command.h"
#include "demos/comparisons/measure_table.h"
#include "demos/comparisons/sweeping.h"
#include "demos/figure/runs_figure.h"
#include "demos/film/film.h"
#include "demos/film/progress.h"
#include "demos/film/variant_panels.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/table.h"

namespace demos {
namespace {

FilmPlan gridOf(const std::vector<Variant>& variants, const SweepOptions& options) {
    FilmPlan film = planFilm(panelsOf(spread(variants)), false, options);
    film.name = film.scene().name + "-sweep";
    return film;
}

std::vector<int> plotted(const SweepOptions& options) {
    if (!options.measure.empty()) return {measureCalled(options.measure)};
    std::vector<int> all = {measureCalled("drift"), measureCalled("penetration"),
                            measureCalled("separation"), measureCalled("residual")};
    if (!options.width) all.push_back(measureCalled("ms"));  // varies from run to run
    return all;
}

std::vector<Chart> chartsOf(const std::vector<Measured>& runs, const std::string& key,
                            const SweepOptions& options) {
    std::vector<Chart> charts;
    for (const int measure : plotted(options)) {
        const bool all0 = std::all_of(runs.begin(), runs.end(), [&](const Measured& run) {
            return run.summary.values[static_cast<std::size_t>(measure)] == 0.0;
        });
        if (!all0 || !options.measure.empty()) charts.push_back(sweepChart(runs, measure, key));
    }
    return charts;
}

RunsFigure figureOf(const std::vector<Variant>& variants, const SweepOptions& options) {
    RunsFigureSettings settings;
    settings.runs = variants;
    if (options.width && !options.outputs.empty())
        settings.pictured = spread(variants);
    settings.title = titleOf(variants.front().scene);
    return RunsFigure(std::move(settings), options);
}

Exit sweep(const SweepOptions& options) {
    if (options.over.empty())
        throw Stop(Exit::usage, "sweep needs --over, for example --over solver.sweeps=1..64:x2");
    const Sweeping sweeping = sweepingOf(options);
    const std::vector<Variant>& variants = sweeping.variants;
    const RunsInParts parts =
        inParts(options, variants.front().scene.name + "-sweep", variants, false);
    if (options.shard && !options.dryRun) {
        watchSignals();
        return runPart(parts, variants, options);
    }
    checkFigureOptions(options, !options.outputs.empty(), "-o FIGURE.png or --plot FILE");
    const RunsFigure figure = figureOf(variants, options);
    std::optional<FilmPlan> grid;
    if (!options.outputs.empty() && !options.width) {
        grid = gridOf(variants, options);
        checkFilmPlan(*grid, options);
    }
    if (options.dryRun) return sayRuns(variants, options);
    watchSignals();
    const bool csvOnStdout = options.csv == "-";
    const bool dataOnStdout =
        csvOnStdout ||
        std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end();
    const Talk talk(options, dataOnStdout);
    const std::vector<Measured> runs = measuredRuns(parts, variants, options, talk);
    if (!options.json) fmt::print(dataOnStdout ? stderr : stdout, "{}\n", tableText(runs));
    std::fflush(stdout);
    if (const std::string line = incidentLine(runs); !line.empty()) talk.mention(printable(line));
    if (const std::string line = failedRunsLine(runs); !line.empty()) talk.mention(printable(line));
    if (!options.csv.empty()) {
        const std::string text = csvText(runs, sweeping.key);
        writeResult(options.csv, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        if (!csvOnStdout) talk.say(fmt::format("wrote {}", printable(options.csv)));
    }
    figure.write({}, chartsOf(runs, sweeping.key, options), talk);
    if (grid) makeFilm(*grid, options);
    return Exit::ok;
}

Run addSweep(CLI::App& app) {
    const auto asked = std::make_shared<Asked<SweepOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addRuns(app, options, texts);
    app.add_option("--over", options.over,
                   "a setting and its values: KEY=1,4,16 or a range: 1..64, 1..64:x2, 0..1:0.25")
        ->type_name("KEY=RANGE");
    app.add_option("--csv", options.csv,
                   "one row per value, with all measures; default: not written")
        ->type_name("FILE|-");
    app.add_option("--plot", options.plot,
                   "the measures over the values, as .svg or .png; default: not drawn")
        ->type_name("FILE");
    takesAgain(
        app.add_option(
               "-o,--output", options.outputs,
               "a film of up to 16 of the runs in a grid, as for render; with --width, one "
               ".png; default: none")
            ->type_name("OUT"));
    return [asked](const std::string& commandLine) {
        SweepOptions& given = settled(*asked, commandLine);
        checkRuns(given, asked->texts);
        spareScenes(given.scenes, {given.csv});
        spareOthers(ResultKind::table, {given.csv});
        return sweep(given);
    };
}

}  // namespace

Command sweepCommand() {
    return {"sweep",
            "one setting over many values: a table, a plot, a grid of films",
            {"impulse sweep chain --over solver.substeps=1..32:x2",
             "impulse sweep stack --over solver.sweeps=1..20 --csv sweeps.csv --plot sweeps.svg",
             "impulse sweep bridge --over world.hz=30,60,120,240 -o grid.mp4"},
            addSweep};
}

}  // namespace demos
