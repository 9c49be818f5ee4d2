#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "demos/commands/commands.h"
#include "demos/commands/runs_command.h"
#include "demos/comparisons/comparing.h"
#include "demos/comparisons/comparisons.h"
#include "demos/comparisons/measure_table.h"
#include "demos/figure/runs_figure.h"
#include "demos/film/film.h"
#include "demos/film/plot_strip.h"
#include "demos/film/progress.h"
#include "demos/film/variant_panels.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

void sayComparisons(const CompareOptions& options) {
    for (const Comparison& comparison : builtinComparisons()) {
        if (options.json)
            fmt::print("{{\"name\":{},\"scene\":{},\"point\":{}}}\n", jsonString(comparison.name),
                       jsonString(comparison.scene), jsonString(comparison.point));
        else
            fmt::print("{:10} {:10} {}\n", comparison.name, comparison.scene, comparison.point);
    }
}

int plottedMeasure(const Comparing& plan) {
    const std::string word = !plan.options.measure.empty()                ? plan.options.measure
                             : !plan.plot.empty()                         ? plan.plot
                             : plan.variants.front().scene.joints.empty() ? "penetration"
                                                                          : "separation";
    return measureCalled(word);
}

FilmPlan filmOf(const Comparing& plan) {
    FilmPlan film = planFilm(panelsOf(plan.variants), plan.options.strip, plan.options);
    film.name = plan.name + "-compare";
    return film;
}

/// Labels the chart's lines with the letters of the pictures.
std::vector<Chart> lettered(Chart chart) {
    for (std::size_t i = 0; i < chart.series.size(); ++i)
        chart.series[i].label = panelLetter(static_cast<int>(i));
    return {std::move(chart)};
}

RunsFigure figureOf(const Comparing& plan) {
    RunsFigureSettings settings;
    settings.runs = plan.variants;
    if (plan.options.width && plan.options.film) settings.pictured = plan.variants;
    settings.columns = plan.variants.size() == kMostCompared ? 2 : 0;
    settings.chart = plan.options.strip;
    settings.title = plan.point.empty() ? titleOf(plan.variants.front().scene)
                                        : plan.name + ": " + plan.point;
    const auto first = static_cast<unsigned char>(settings.title.front());
    settings.title.front() = static_cast<char>(std::toupper(first));
    settings.picture = "output/" + plan.name + "-compare.png";
    return RunsFigure(std::move(settings), plan.options);
}

Exit compare(const CompareOptions& options) {
    if (options.listOnly) {
        sayComparisons(options);
        return Exit::ok;
    }
    if (options.scenes.empty()) {
        std::vector<std::string> names;
        for (const Comparison& comparison : builtinComparisons())
            names.emplace_back(comparison.name);
        throw Stop(Exit::usage, fmt::format("compare needs a scene and --vary, or one of: {}",
                                            fmt::join(names, ", ")));
    }
    const Comparing plan = comparingOf(options);
    if (!options.film && !options.outputs.empty())
        refuse(
            fmt::format("--output '{}' and --no-film: there are no pictures to write; leave one of "
                        "them out",
                        printable(options.outputs.front())));
    const RunsInParts parts =
        inParts(plan.options, plan.name + "-compare", plan.variants, true);
    if (options.shard && !options.dryRun) {
        watchSignals();
        return runPart(parts, plan.variants, options);
    }
    checkFigureOptions(options, options.film, "--plot FILE, or leave --no-film out");
    const RunsFigure figure = figureOf(plan);
    std::optional<FilmPlan> film;
    if (options.film && !options.width) {
        film = filmOf(plan);
        checkFilmPlan(*film, plan.options);
    }
    if (options.dryRun) return sayRuns(plan.variants, options);
    watchSignals();
    const bool raw =
        std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end();
    const Talk talk(options, raw);
    const std::vector<Measured> runs = measuredRuns(parts, plan.variants, options, talk);
    if (!plan.point.empty()) talk.say(fmt::format("{}: {}", plan.name, plan.point));
    if (!options.json) fmt::print(raw ? stderr : stdout, "{}\n", tableText(runs));
    std::fflush(stdout);
    if (const std::string line = incidentLine(runs); !line.empty()) talk.mention(printable(line));
    if (const std::string line = failedRunsLine(runs); !line.empty()) talk.mention(printable(line));
    const Chart chart = historyChart(runs, plottedMeasure(plan), "");
    figure.write(lettered(chart), {chart}, talk);
    if (!film) return Exit::ok;
    if (options.strip) addStrip({chart}, *film);
    makeFilm(*film, plan.options);
    return Exit::ok;
}

Run addCompare(CLI::App& app) {
    const auto asked = std::make_shared<Asked<CompareOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addRuns(app, options, texts);
    app.get_option("scene")->expected(0, 1)->required(false);
    takesAgain(app.add_option(
                      "--vary", options.vary,
                      "a setting and its values, e.g. solver.nudges=0,4; given again: all "
                      "combinations")
                   ->type_name("KEY=A,B"));
    takesAgain(
        app.add_option(
               "--case", options.cases,
               "one set of settings, 'LABEL: KEY=VALUE KEY=VALUE'; give two to four of them")
            ->type_name("CASE"));
    app.add_option("--plot", options.plot,
                   "only the chart of the measure over time, as .svg or .png; default: not drawn")
        ->type_name("FILE");
    takesAgain(
        app.add_option("-o,--output", options.outputs,
                       "as for render; with --width, one .png; default: output/<scene>-compare")
            ->type_name("OUT"));
    app.add_flag("--film,!--no-film", options.film, "draw the film; default: on");
    app.add_flag("--strip,!--no-strip", options.strip,
                 "draw a plot below the pictures; default: on");
    app.add_flag("--list", options.listOnly, "list the built-in comparisons; default: off");
    return [asked](const std::string& commandLine) {
        CompareOptions& given = settled(*asked, commandLine);
        checkRuns(given, asked->texts);
        return compare(given);
    };
}

}  // namespace

Command compareCommand() {
    return {
        "compare",
        "one scene under two to four settings, side by side in one film, with a table",
        {"impulse compare clamping", "impulse compare stack --vary solver.nudges=0,4 -o nudges.mp4",
         "impulse compare chain --no-film --vary solver.type=impulses,pgs --set "
         "solver.preset=seed"},
        addCompare};
}

}  // namespace demos
