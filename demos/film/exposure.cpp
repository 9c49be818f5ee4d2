#include "demos/film/exposure.h"

#include <algorithm>

#include "demos/film/framing.h"
#include "render/corners.h"

namespace demos {
namespace {

bool isStats(const render::Plate& plate) { return plate.corner == render::Corner::topRight; }

/// A panel of statistics without room is left out, and a first line says the most important ones.
void chooseStats(const FilmPlan& plan, render::Frame& frame) {
    const Overlays& shown = plan.panels.front().overlays;
    if (!shown.stats) return;
    render::Frame without = frame;
    const bool firstLine = shown.text && shown.headings && shown.clock;
    if (firstLine) without.texts.erase(without.texts.begin());
    const render::CornerLayout placed =
        render::layoutCorners(without, plan.picture.width, plan.picture.height);
    const bool fit = std::any_of(placed.plates.begin(), placed.plates.end(),
                                 [](const auto& one) { return isStats(*one.plate); });
    if (!fit)
        std::erase_if(frame.plates, isStats);
    else if (firstLine)
        frame.texts.erase(frame.texts.begin());
}

/// In a small picture a legend would cover what it explains; the caption says the same. Legends of
/// colours by group or material stay, since only they have the names.
void chooseLegend(const FilmPlan& plan, render::Frame& frame) {
    constexpr double kLeastWidth = 120.0;  // mm
    const Overlays& shown = plan.panels.front().overlays;
    const double width = 25.4 / 72.0 * plan.picture.width / shown.pixelsPerPoint;
    const bool listed = shown.colorBy == "group" || shown.colorBy == "material";
    if (width >= kLeastWidth || listed) return;
    std::erase_if(frame.plates, [](const render::Plate& plate) { return !isStats(plate); });
}

/// On paper letters do not shrink.
void chooseTexts(const FilmPlan& plan, render::Frame& frame) {
    if (!(plan.panels.front().overlays.pixelsPerPoint > 0.0)) return;
    chooseLegend(plan, frame);
    chooseStats(plan, frame);
}

}  // namespace

std::vector<render::Frame> playTo(double time, int steps, const FilmPlan& plan, Player& player) {
    const Shutter shutter(plan.shutter, plan.stepsTo(time));
    std::vector<render::Frame> seen;
    for (int left = steps; left >= 0; --left) {
        if (shutter.sees(left)) {
            seen.push_back(player.frame(time - static_cast<double>(left) / plan.scene().hz));
            chooseTexts(plan, seen.back());
            fitCamera(plan.picture.width, plan.picture.height, seen.back());
        }
        if (left > 0) player.step();
    }
    return seen;
}

render::Image exposed(const std::vector<render::Frame>& seen, double time, const FilmPlan& plan,
                      render::Renderer& renderer) {
    if (plan.shutter.moments <= 1) return renderer.draw(seen.back());
    return renderer.draw(Shutter(plan.shutter, plan.stepsTo(time)).moments(seen));
}

}  // namespace demos
