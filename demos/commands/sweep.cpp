#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "demos/commands/commands.h"
#include "demos/commands/table.h"
#include "demos/figure/runs_figure.h"
#include "demos/film/film.h"
#include "demos/film/progress.h"
#include "demos/film/signals.h"
#include "demos/film/variant_panels.h"
#include "demos/report/measure_table.h"
#include "demos/report/sweeping.h"
#include "demos/scene/complaints.h"

namespace demos {
namespace {

FilmPlan gridOf(const std::vector<Variant>& variants, const Options& options) {
    FilmPlan film = planFilm(panelsOf(spread(variants)), false, options);
    film.name = film.scene().name + "-sweep";
    return film;
}

std::vector<int> plotted(const Options& options) {
    if (!options.measure.empty()) return {measureCalled(options.measure)};
    std::vector<int> all = {measureCalled("drift"), measureCalled("penetration"),
                            measureCalled("separation"), measureCalled("residual")};
    if (!options.width) all.push_back(measureCalled("ms"));  // no two runs take the same time
    return all;
}

std::vector<Chart> chartsOf(const std::vector<Measured>& runs, const std::string& key,
                            const Options& options) {
    std::vector<Chart> charts;
    for (const int measure : plotted(options)) {
        const bool all0 = std::all_of(runs.begin(), runs.end(), [&](const Measured& run) {
            return run.summary.values[static_cast<std::size_t>(measure)] == 0.0;
        });
        if (!all0 || !options.measure.empty()) charts.push_back(sweepChart(runs, measure, key));
    }
    return charts;
}

RunsFigure figureOf(const std::vector<Variant>& variants, const Options& options) {
    RunsFigureSettings settings;
    settings.runs = variants;
    if (options.width && !options.outputs.empty())
        settings.pictured = spread(variants);
    settings.title = titleOf(variants.front().scene);
    return RunsFigure(std::move(settings), options);
}

}  // namespace

Exit sweepCommand(const Options& options) {
    if (options.over.empty())
        throw Stop(Exit::usage, "sweep needs --over, for example --over solver.sweeps=1..64:x2");
    const Sweeping sweeping = sweepingOf(options);
    const std::vector<Variant>& variants = sweeping.variants;
    checkFigureOptions(options);
    const RunsFigure figure = figureOf(variants, options);
    std::optional<FilmPlan> grid;
    if (!options.outputs.empty() && !options.width) {
        grid = gridOf(variants, options);
        checkFilmPlan(*grid, options);
    }
    watchSignals();
    const bool csvOnStdout = options.csv == "-";
    const bool dataOnStdout =
        csvOnStdout ||
        std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end();
    const Talk talk(options, dataOnStdout);
    std::vector<Measured> runs;
    for (const Variant& variant : variants) {
        runs.push_back({variant, summarize(variant.scene)});
        talk.json(jsonLine(runs.back()));
    }
    if (!options.json) fmt::print(dataOnStdout ? stderr : stdout, "{}\n", tableText(runs));
    std::fflush(stdout);
    if (!options.csv.empty()) {
        const std::string text = csvText(runs, sweeping.key);
        writeResult(options.csv, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        if (!csvOnStdout) talk.say(fmt::format("wrote {}", printable(options.csv)));
    }
    figure.write({}, chartsOf(runs, sweeping.key, options), talk);
    if (grid) makeFilm(*grid, options);
    return Exit::ok;
}

}  // namespace demos
