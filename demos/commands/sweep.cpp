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
#include "demos/report/measure_table.h"
#include "demos/scene/complaints.h"

namespace demos {
namespace {

constexpr std::size_t kMostPanels = 16;

std::vector<std::string> shortLabels(const Variation& variation) {
    const std::size_t dot = variation.key.find_last_of('.');
    const std::string name =
        dot == std::string::npos ? variation.key : variation.key.substr(dot + 1);
    std::vector<std::string> labels;
    for (const std::string& value : variation.values) labels.push_back(name + " = " + value);
    return labels;
}

/// At most 16 of them, the first and the last among them.
std::vector<const Variant*> spread(const std::vector<Variant>& variants) {
    std::vector<const Variant*> chosen;
    const std::size_t count = std::min(variants.size(), kMostPanels);
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(&variants[count == 1 ? 0 : i * (variants.size() - 1) / (count - 1)]);
    return chosen;
}

FilmPlan gridOf(const std::vector<Variant>& variants, const Options& options) {
    std::vector<Panel> panels;
    for (const Variant* variant : spread(variants)) {
        Panel panel;
        panel.scene = variant->scene;
        panel.settings = variant->settings.back();
        panel.scene.title = variant->label;
        panel.scene.sections.clear();
        panels.push_back(std::move(panel));
    }
    FilmPlan film = planFilm(std::move(panels), false, options);
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
        for (const Variant* variant : spread(variants)) settings.pictured.push_back(*variant);
    settings.title = titleOf(variants.front().scene);
    return RunsFigure(std::move(settings), options);
}

}  // namespace

Exit sweepCommand(const Options& options) {
    if (options.over.empty())
        throw Stop(Exit::usage, "sweep needs --over, for example --over solver.sweeps=1..64:x2");
    const Variation variation = rangeFrom(options.over, "--over");
    const std::vector<Variant> variants =
        variantsOf(options, combinations({variation}), shortLabels(variation), "--over");
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
        const std::string text = csvText(runs, variation.key);
        writeResult(options.csv, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        if (!csvOnStdout) talk.say(fmt::format("wrote {}", printable(options.csv)));
    }
    figure.write({}, chartsOf(runs, variation.key, options), talk);
    if (grid) makeFilm(*grid, options);
    return Exit::ok;
}

}  // namespace demos
