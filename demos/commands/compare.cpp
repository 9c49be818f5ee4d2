#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "demos/commands/commands.h"
#include "demos/figure/runs_figure.h"
#include "demos/film/film.h"
#include "demos/film/plot_strip.h"
#include "demos/film/progress.h"
#include "demos/film/signals.h"
#include "demos/report/comparisons.h"
#include "demos/report/measure_table.h"
#include "demos/scene/builtin.h"
#include "demos/scene/complaints.h"
#include "demos/scene/nearest.h"

namespace demos {
namespace {

constexpr std::size_t kMostPanels = 4;

struct Plan {
    Options options;  // with the built-in comparison's scene and length
    std::string name, point;
    std::string plot;  // a measure
    std::vector<Variant> variants;
};

void sayComparisons(const Options& options) {
    for (const Comparison& comparison : builtinComparisons()) {
        if (options.json)
            fmt::print("{{\"name\":{},\"scene\":{},\"point\":{}}}\n", jsonString(comparison.name),
                       jsonString(comparison.scene), jsonString(comparison.point));
        else
            fmt::print("{:10} {:10} {}\n", comparison.name, comparison.scene, comparison.point);
    }
}

Plan planOf(const Comparison& comparison, const Options& options) {
    Plan plan{options, comparison.name, comparison.point, comparison.plot, {}};
    plan.options.scenes = {comparison.scene};
    if (!options.seconds) plan.options.seconds = comparison.seconds;
    std::vector<std::vector<std::string>> settings;
    std::vector<std::string> labels;
    for (const Comparison::Case& one : comparison.cases) {
        settings.push_back(one.settings);
        labels.emplace_back(one.label);
    }
    plan.variants = variantsOf(plan.options, settings, labels, "--vary");
    return plan;
}

/// "label: key=value key=value"; the label may be left out.
std::pair<std::string, std::vector<std::string>> caseFrom(const std::string& text) {
    const std::size_t colon = text.find(": ");
    std::vector<std::string> settings(1);
    for (const char c : colon == std::string::npos ? text : text.substr(colon + 2)) {
        if (c != ' ')
            settings.back() += c;
        else if (!settings.back().empty())
            settings.emplace_back();
    }
    if (settings.back().empty()) settings.pop_back();
    for (const std::string& setting : settings)
        if (setting.find('=') == std::string::npos)
            throw Stop(Exit::usage,
                       fmt::format("--case '{}': must be 'LABEL: KEY=VALUE KEY=VALUE', for example "
                                   "'fine: solver.substeps=8 solver.sweeps=2'",
                                   printable(text)));
    return {colon == std::string::npos ? "" : text.substr(0, colon), settings};
}

Plan planOf(const Options& options) {
    if (const Comparison* comparison = comparisonCalled(options.scene())) {
        if (!options.vary.empty() || !options.cases.empty())
            throw Stop(Exit::usage, fmt::format("'{}' is a comparison of its own; for --vary and "
                                                "--case name a scene",
                                                comparison->name));
        return planOf(*comparison, options);
    }
    Plan plan{options, "", "", "", {}};
    if (!options.vary.empty() && !options.cases.empty())
        throw Stop(Exit::usage, "--vary and --case cannot be given together; use one of them");
    std::vector<Variation> variations;
    for (const std::string& text : options.vary)
        variations.push_back(variationFrom(text, "--vary"));
    std::vector<std::vector<std::string>> settings;
    std::vector<std::string> labels;
    if (!variations.empty()) settings = combinations(variations);
    for (const std::string& text : options.cases) {
        auto [label, own] = caseFrom(text);
        labels.push_back(label);
        settings.push_back(own);
    }
    if (settings.size() < 2 || settings.size() > kMostPanels)
        throw Stop(Exit::usage,
                   fmt::format("{} to compare; give two to four, for example --vary "
                               "solver.sweeps=1,4,16; built in: see impulse compare --list",
                               settings.size()));
    plan.variants =
        variantsOf(options, settings, labels, options.vary.empty() ? "--case" : "--vary");
    plan.name = plan.variants.front().scene.name;
    return plan;
}

int plottedMeasure(const Plan& plan) {
    const std::string word = !plan.options.measure.empty()                ? plan.options.measure
                             : !plan.plot.empty()                         ? plan.plot
                             : plan.variants.front().scene.joints.empty() ? "penetration"
                                                                          : "separation";
    return measureCalled(word);
}

FilmPlan filmOf(const Plan& plan) {
    std::vector<Panel> panels;
    for (const Variant& variant : plan.variants) {
        Panel panel;
        panel.scene = variant.scene;
        panel.settings = fmt::format("{}", fmt::join(variant.settings, " "));
        panel.scene.title = variant.label;
        panel.scene.sections.clear();
        panels.push_back(std::move(panel));
    }
    FilmPlan film = planFilm(std::move(panels), plan.options.strip, plan.options);
    film.name = plan.name + "-compare";
    return film;
}

/// What the chart's lines are called where the pictures have letters.
std::vector<Chart> lettered(Chart chart) {
    for (std::size_t i = 0; i < chart.series.size(); ++i)
        chart.series[i].label = panelLetter(static_cast<int>(i));
    return {std::move(chart)};
}

RunsFigure figureOf(const Plan& plan) {
    RunsFigureSettings settings;
    settings.runs = plan.variants;
    if (plan.options.width && plan.options.film) settings.pictured = plan.variants;
    settings.columns = plan.variants.size() == kMostPanels ? 2 : 0;
    settings.chart = plan.options.strip;
    settings.title = plan.point.empty() ? titleOf(plan.variants.front().scene)
                                        : plan.name + ": " + plan.point;
    const auto first = static_cast<unsigned char>(settings.title.front());
    settings.title.front() = static_cast<char>(std::toupper(first));
    settings.picture = "output/" + plan.name + "-compare.png";
    return RunsFigure(std::move(settings), plan.options);
}

}  // namespace

Exit compareCommand(const Options& options) {
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
    const Plan plan = planOf(options);
    checkFigureOptions(options);
    const RunsFigure figure = figureOf(plan);
    std::optional<FilmPlan> film;
    if (options.film && !options.width) {
        film = filmOf(plan);
        checkFilmPlan(*film, plan.options);
    }
    watchSignals();
    const bool raw =
        std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end();
    const Talk talk(options, raw);
    std::vector<Measured> runs;
    for (const Variant& variant : plan.variants) {
        runs.push_back({variant, summarize(variant.scene)});
        talk.json(jsonLine(runs.back()));
    }
    if (!plan.point.empty()) talk.say(fmt::format("{}: {}", plan.name, plan.point));
    if (!options.json) fmt::print(raw ? stderr : stdout, "{}\n", tableText(runs));
    std::fflush(stdout);
    const Chart chart = historyChart(runs, plottedMeasure(plan), "");
    figure.write(lettered(chart), {chart}, talk);
    if (!film) return Exit::ok;
    if (options.strip) addStrip({chart}, *film);
    makeFilm(*film, plan.options);
    return Exit::ok;
}

}  // namespace demos
