#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "demos/commands/commands.h"
#include "demos/commands/table.h"
#include "demos/film/film.h"
#include "demos/film/progress.h"
#include "demos/film/signals.h"
#include "demos/film/variant_panels.h"
#include "demos/report/measure_table.h"
#include "demos/report/plot_file.h"
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
    return {measureCalled("drift"), measureCalled("penetration"), measureCalled("separation"),
            measureCalled("residual"), measureCalled("ms")};
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

}  // namespace

Exit sweepCommand(const Options& options) {
    if (options.over.empty())
        throw Stop(Exit::usage, "sweep needs --over, for example --over solver.sweeps=1..64:x2");
    const Sweeping sweeping = sweepingOf(options);
    const std::vector<Variant>& variants = sweeping.variants;
    if (!options.plot.empty()) checkChartFile(options.plot);
    std::optional<FilmPlan> grid;
    if (!options.outputs.empty()) {
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
    if (!options.plot.empty()) {
        const std::vector<Chart> charts = chartsOf(runs, sweeping.key, options);
        const std::string theme =
            options.theme.empty() ? variants.front().scene.look.theme : options.theme;
        writeCharts(options.plot, charts, chartSize(charts.size()), theme);
        talk.say(fmt::format("wrote {}", printable(options.plot)));
    }
    if (grid) makeFilm(*grid, options);
    return Exit::ok;
}

}  // namespace demos
