#include "demos/figure/shot.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/page/rounded.h"
#include "demos/snapshot/colors.h"
#include "demos/snapshot/scale.h"
#include "render/corners.h"

namespace demos {
namespace {

/// Units of 1 cm on paper; 0 where there is nothing to show, or no paper.
double perCentimetre(const ArrowScale& scale, double pixelsPerMeter, const Paper& paper) {
    if (!(scale.metersPerUnit > 0.0) || !paper.given()) return 0.0;
    return paper.dpi / 2.54 / (scale.metersPerUnit * pixelsPerMeter);
}

/// "50", or "50, 12, -" of pictures with scales of their own.
template <class Value>
std::string listOf(const std::vector<Shot>& shots, Value value) {
    std::vector<std::string> texts;
    for (const Shot& shot : shots)
        texts.push_back(value(shot) > 0.0 ? fmt::format("{:g}", rounded(value(shot), 3)) : "-");
    const bool alike = std::all_of(texts.begin(), texts.end(),
                                   [&](const std::string& text) { return text == texts.front(); });
    if (alike) texts.resize(1);
    return fmt::format("{}", fmt::join(texts, ", "));
}

template <class Value>
std::string arrowText(const char* what, const char* unit, const std::vector<Shot>& shots,
                      Value value) {
    const bool known = std::any_of(shots.begin(), shots.end(),
                                   [&](const Shot& shot) { return value(shot) > 0.0; });
    if (!known) return fmt::format("; {}", what);
    return fmt::format("; {}, 1 cm = {} {}", what, listOf(shots, value), unit);
}

}  // namespace

Shot shotOf(const Player& player, const FilmPlan& plan, const render::Frame& frame,
            const Paper& paper) {
    const Stage& stage = player.stage();
    const History& history = player.history();
    const double view = viewHeight(stage.scene.camera);
    const double meter =
        static_cast<double>(render::pixelsPerMeter(frame.camera, plan.picture.height));
    Shot shot;
    shot.step = stage.world.report().step;
    shot.time = static_cast<double>(shot.step) / stage.scene.hz;
    shot.state = stage.world.hash();
    shot.impulse = perCentimetre(ArrowScale(history.impulsePeak, view), meter, paper);
    shot.nudge = 1e3 * perCentimetre(ArrowScale(history.nudgePeak, view), meter, paper);
    shot.colorEnd = scaleEnd(plan.panels.front().overlays, history);
    return shot;
}

std::string timesText(const std::vector<Shot>& shots) {
    std::vector<std::string> times;
    for (const Shot& shot : shots) times.push_back(fmt::format("{:g}", rounded(shot.time, 4)));
    const bool alike = std::all_of(times.begin(), times.end(),
                                   [&](const std::string& time) { return time == times.front(); });
    if (alike && !times.empty()) times.resize(1);
    return fmt::format("t = {} s", fmt::join(times, ", "));
}

std::string scalesText(const Overlays& overlays, const std::vector<Shot>& shots) {
    std::string text;
    const auto impulse = [](const Shot& shot) { return shot.impulse; };
    if (overlays.impulses)
        text += arrowText("red arrows: impulses along the normals", "N s", shots, impulse);
    if (overlays.friction) text += arrowText("orange arrows: friction", "N s", shots, impulse);
    if (overlays.nudges)
        text += arrowText("violet arrows: nudges", "mm", shots,
                          [](const Shot& shot) { return shot.nudge; });
    const std::string& by = overlays.colorBy;
    if (by == "speed" || by == "impulse")
        text += fmt::format("; colours: {}, 0 to {} {} (viridis)", by,
                            listOf(shots, [](const Shot& shot) { return shot.colorEnd; }),
                            by == "speed" ? "m/s" : "N s");
    else if (by != "body")
        text += fmt::format("; colours: {}", by);
    return text;
}

std::string leftOut(const render::Frame& frame, int width, int height) {
    const render::CornerLayout placed = render::layoutCorners(frame, width, height);
    for (const render::Plate& plate : frame.plates) {
        const bool there =
            plate.rows.empty() || std::any_of(placed.plates.begin(), placed.plates.end(),
                                              [&](const auto& one) { return one.plate == &plate; });
        if (!there) return plate.corner == render::Corner::topRight ? "stats" : "legend";
    }
    return {};
}

}  // namespace demos
