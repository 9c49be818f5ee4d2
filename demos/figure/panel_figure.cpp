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
#include "demos/play/motion_camera.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

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

/// In the figure's size of letters.
render::Text markOf(const std::string& what) {
    render::Text mark = incidentMark(what);
    mark.size = render::Plate{}.size;
    return mark;
}

/// The last good state, marked as such.
std::vector<render::Frame> lastGood(const FilmPlan& plan, const Player& player, double time) {
    render::Frame frame = player.frame(time);
    fitCamera(plan.picture.width, plan.picture.height, frame);
    frame.texts.push_back(markOf("the last good state"));
    return {frame};
}

/// The run up to the figure's time. `failed`: empty, or the line of the step that failed before.
std::vector<render::Frame> seenOf(const PanelFigure& figure, const FilmPlan& plan, Player& player,
                                  std::string& failed) try {
    const double time = figure.time;
    std::vector<render::Frame> seen = playTo(time, stepAt(time, plan, "--time"), plan, player);
    if (!player.incidents().empty())
        for (render::Frame& frame : seen)
            frame.texts.push_back(markOf(bodyAndStep(player.incidents().front())));
    return seen;
} catch (const Stop& stop) {
    if (stop.code() != Exit::diverged) throw;
    failed = stop.what();
    return lastGood(plan, player, figure.time);
}

void drawPanel(const PanelFigure& figure, std::size_t i, render::Renderer& renderer,
               DrawnPanels& drawn) {
    const FilmPlan& plan = figure.plans[i];
    const Overlays& overlays = plan.panels.front().overlays;
    Player player(plan.scene(), overlays);
    std::string failed;
    const std::vector<render::Frame> seen = seenOf(figure, plan, player, failed);
    drawn.diverged.push_back(failed.empty() ? player.incident() : failed);
    drawn.facts.push_back(factsOf(player, plan, seen.back(), figure.paper));
    placePicture(figure.layout, static_cast<int>(i),
                 failed.empty() ? exposed(seen, figure.time, plan, renderer) : renderer.draw(seen.back()),
                 drawn.image);
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
    std::vector<SceneDescription*> scenes;
    for (FilmPlan& plan : figure.plans) scenes.push_back(&plan.panels.front().scene);
    fitToMotion(scenes);
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
