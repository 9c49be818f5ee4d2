#include "demos/figure/panel_figure.h"
#include "demos/options/picture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "demos/film/exposure.h"
#include "demos/film/film_needs.h"
#include "demos/film/framing.h"
#include "demos/film/quality.h"
#include "demos/look/type.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "render/palette.h"

namespace demos {
namespace {

/// Without the scene's own text, which would be the same in every picture.
FilmPlan planOf(const Variant& run, Options options) {
    options.anyStep = true;
    Panel panel;
    panel.scene = run.scene;
    FilmPlan plan = planFilm({std::move(panel)}, false, options);
    Overlays& shown = plan.panels.front().overlays;
    const auto asked = [&](const char* name) {
        return std::find(options.show.begin(), options.show.end(), name) != options.show.end();
    };
    shown.text = asked("caption");
    shown.stats = asked("stats");
    return plan;
}

std::string unspaced(std::string text) {
    std::erase(text, ' ');
    return text;
}

/// "(a) the total is clamped", and below it the settings if the label does not show them.
std::vector<std::string> linesOf(const std::vector<Variant>& runs, std::size_t i,
                                 const StripLayout& layout) {
    const Variant& run = runs[i];
    std::vector<std::string> lines =
        labelLines(panelLetter(static_cast<int>(i)) + " " + printable(run.label), layout);
    const std::string settings = differencesOf(runs, i);
    if (settings.empty() || unspaced(settings) == unspaced(run.label)) return lines;
    for (std::string& line : labelLines(printable(settings), layout)) lines.push_back(line);
    return lines;
}

PictureSize ratioOf(const Options& options) {
    const Quality& quality = qualityOf(options.quality);
    return options.size.value_or(PictureSize{quality.width, quality.height});
}

/// The last good state, marked as such.
std::vector<render::Frame> lastGood(const FilmPlan& plan, const Player& player, double time) {
    render::Frame frame = player.frame(time);
    fitCamera(plan.picture.width, plan.picture.height, frame);
    frame.texts.push_back({"diverged: the last good state", render::Corner::topLeft,
                           render::Plate{}.size, render::fromHex(0xc0392b)});
    return {frame};
}

void drawPanel(const PanelFigure& figure, std::size_t i, render::Renderer& renderer,
               DrawnPanels& drawn) {
    const FilmPlan& plan = figure.plans[i];
    const Overlays& overlays = plan.panels.front().overlays;
    const double time = figure.time;
    Player player(plan.scene(), overlays);
    std::vector<render::Frame> seen;
    drawn.diverged.emplace_back();
    try {
        seen = playTo(time, stepAt(time, plan, "--time"), plan, player);
    } catch (const Stop& stop) {
        if (stop.code() != Exit::diverged) throw;
        drawn.diverged.back() = stop.what();
        seen = lastGood(plan, player, time);
    }
    drawn.facts.push_back(factsOf(player, plan, seen.back(), figure.paper));
    const bool whole = drawn.diverged.back().empty();
    placePicture(figure.layout, static_cast<int>(i),
                 whole ? exposed(seen, plan, renderer) : renderer.draw(seen.back()), drawn.image);
    placeLines(figure.layout, static_cast<int>(i), figure.labels[i], render::Anchor::middle,
               inksOf(overlays.theme).ink, drawn.image);
}

void placeBelow(const render::Image& part, render::Image& whole) {
    for (int row = 0; row < part.height; ++row)
        std::copy_n(part.at(0, row), 4 * part.width, whole.at(0, whole.height - part.height + row));
}

/// The chart below the pictures must include their moment.
void checkTime(double time, double seconds) {
    if (time <= seconds + 1e-9) return;
    throw Stop(Exit::usage,
               fmt::format("--time {:g}: the chart below the pictures ends at {:g} s; give "
                           "--seconds {:g} too, or --no-strip",
                           time, seconds, std::ceil(time)));
}

/// The layout with the chart.
StripLayout wholeOf(const PanelFigure& figure) {
    StripLayout whole = figure.layout;
    whole.height = figure.height;
    return whole;
}

}  // namespace

PanelFigure planPanels(const std::vector<Variant>& runs, int columns, bool chart,
                       const RunsOptions& options) {
    PanelFigure figure;
    figure.paper = paperOf(options);
    const int count = static_cast<int>(runs.size());
    const PictureSize ratio = ratioOf(options);
    figure.layout = figureLayout(count, columns, ratio, figure.paper, 1);
    int lines = 1;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        figure.labels.push_back(linesOf(runs, i, figure.layout));
        lines = std::max(lines, static_cast<int>(figure.labels.back().size()));
    }
    figure.layout = figureLayout(count, columns, ratio, figure.paper, lines);
    if (chart) figure.chart = chartBelow(figure.paper);
    figure.height = figure.layout.height + figure.chart.height;
    checkLayout(wholeOf(figure), figure.paper);
    Options own = options;
    own.size = figure.layout.picture;
    for (const Variant& run : runs) figure.plans.push_back(planOf(run, own));
    const FilmPlan& first = figure.plans.front();
    figure.time = options.time.value_or(first.timeOf(first.frames - 1));
    for (const FilmPlan& plan : figure.plans) stepAt(figure.time, plan, "--time");
    if (chart) checkTime(figure.time, runs.front().scene.seconds);
    checkNeeds(needsOf(first, 1, {}), first);
    return figure;
}

DrawnPanels drawPanels(const PanelFigure& figure, const std::vector<Chart>& charts) {
    const FilmPlan& first = figure.plans.front();
    const std::string& theme = first.panels.front().overlays.theme;
    render::Color ground = inksOf(theme).ground;
    if (first.alpha()) ground.a = 0.0f;
    DrawnPanels drawn;
    drawn.image = stripPaper(wholeOf(figure), ground);
    render::Renderer renderer(first.picture);
    for (std::size_t i = 0; i < figure.plans.size(); ++i) {
        drawPanel(figure, i, renderer, drawn);
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted; no figure was written");
    }
    if (figure.chart.height > 0)
        placeBelow(imageOf(charts, figure.chart, theme, figure.paper), drawn.image);
    return drawn;
}

}  // namespace demos
