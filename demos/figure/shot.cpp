#include "demos/figure/shot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/page/rounded.h"
#include "demos/snapshot/colors.h"
#include "demos/snapshot/scale.h"
#include "demos/theme.h"
#include "render/corners.h"
#include "render/palette.h"

namespace demos {
namespace {

/// Units of 1 cm on paper; 0 where there is nothing to show, or no paper.
double perCentimetre(const ArrowScale& scale, double pixelsPerMeter, const Paper& paper) {
    if (!(scale.metersPerUnit > 0.0) || !paper.given()) return 0.0;
    return paper.dpi / 2.54 / (scale.metersPerUnit * pixelsPerMeter);
}

/// "50 N s", or of pictures with scales of their own "50, 12 N s", "50 N s, none".
template <class Value>
std::string listOf(const std::vector<Shot>& shots, Value value, const std::string& unit) {
    std::vector<std::string> texts;
    bool all = true;
    for (const Shot& shot : shots) all = all && value(shot) > 0.0;
    for (const Shot& shot : shots) {
        const bool known = value(shot) > 0.0;
        texts.push_back(known ? fmt::format("{:g}", rounded(value(shot), 3)) : "none");
        if (known && !all) texts.back() += " " + unit;
    }
    const bool alike = std::all_of(texts.begin(), texts.end(),
                                   [&](const std::string& text) { return text == texts.front(); });
    if (alike) texts.resize(1);
    return fmt::format("{}{}", fmt::join(texts, ", "), all ? " " + unit : "");
}

template <class Value>
std::string arrowText(const char* what, const char* unit, const std::vector<Shot>& shots,
                      Value value) {
    const bool known = std::any_of(shots.begin(), shots.end(),
                                   [&](const Shot& shot) { return value(shot) > 0.0; });
    const bool onPaper = std::any_of(shots.begin(), shots.end(),
                                     [](const Shot& shot) { return shot.onPaper; });
    if (!known) return onPaper ? "" : fmt::format("; {}", what);
    return fmt::format("; {}, 1 cm = {}", what, listOf(shots, value, unit));
}

bool hasArrow(const render::Frame& frame, const render::Color& color) {
    return std::any_of(frame.arrows.begin(), frame.arrows.end(), [&](const render::Arrow& arrow) {
        return arrow.color.r == color.r && arrow.color.g == color.g && arrow.color.b == color.b;
    });
}

/// What needs no scale.
std::string marksText(const Overlays& overlays) {
    std::string text;
    if (overlays.contacts) text += "; pink dots: contacts";
    if (overlays.normals) text += "; blue arrows: normals";
    if (overlays.joints) text += "; grey dots: anchors of joints";
    if (overlays.axes) text += "; red, green and blue lines: x, y and z axes of the bodies";
    if (overlays.com) text += "; quartered discs: centres of mass";
    if (overlays.bounds) text += "; teal boxes: bounds along the axes";
    if (overlays.ghost)
        text += fmt::format("; pale bodies: earlier poses, every {:g} s", overlays.ghostEvery);
    return text;
}

bool hasStats(const render::Frame& frame) {
    return std::any_of(frame.plates.begin(), frame.plates.end(), [](const render::Plate& plate) {
        return plate.corner == render::Corner::topRight;
    });
}

void addOnce(const std::string& name, std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
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
    const double impulse = perCentimetre(ArrowScale(history.impulsePeak, view), meter, paper);
    const double nudge = perCentimetre(ArrowScale(history.nudgePeak, view), meter, paper);
    if (hasArrow(frame, render::impulseColor())) shot.impulse = impulse;
    if (hasArrow(frame, render::frictionColor())) shot.friction = impulse;
    if (hasArrow(frame, nudgeColor())) shot.nudge = 1e3 * nudge;
    shot.colorEnd = scaleEnd(plan.panels.front().overlays, history);
    shot.onPaper = paper.given();
    if (shot.onPaper) shot.leftOut = leftOut(frame, plan.picture.width, plan.picture.height);
    if (shot.onPaper && plan.panels.front().overlays.stats && !hasStats(frame))
        addOnce("stats", shot.leftOut);  // they gave way to the first line
    return shot;
}

std::string timesText(const std::vector<Shot>& shots) {
    std::vector<std::string> times;
    bool coarse = true;  // in hundredths of a second
    for (const Shot& shot : shots)
        coarse = coarse && std::abs(std::round(100.0 * shot.time) - 100.0 * shot.time) < 1e-6;
    for (const Shot& shot : shots)
        times.push_back(coarse ? fmt::format("{:g}", shot.time) : fmt::format("{:.3f}", shot.time));
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
    if (overlays.friction)
        text += arrowText("orange arrows: friction", "N s", shots,
                          [](const Shot& shot) { return shot.friction; });
    if (overlays.nudges)
        text += arrowText("violet arrows: nudges", "mm", shots,
                          [](const Shot& shot) { return shot.nudge; });
    text += marksText(overlays);
    const std::string& by = overlays.colorBy;
    if (by == "speed" || by == "impulse")
        text += fmt::format("; colours: {}, 0 to {} (viridis)", by,
                            listOf(
                                shots, [](const Shot& shot) { return shot.colorEnd; },
                                by == "speed" ? "m/s" : "N s"));
    else if (by != "body")
        text += fmt::format("; colours: {}", by);
    return text;
}

std::vector<std::string> leftOut(const render::Frame& frame, int width, int height) {
    const render::CornerLayout placed = render::layoutCorners(frame, width, height);
    std::vector<std::string> names;
    for (const render::Plate& plate : frame.plates) {
        const bool there =
            plate.rows.empty() || std::any_of(placed.plates.begin(), placed.plates.end(),
                                              [&](const auto& one) { return one.plate == &plate; });
        if (!there) addOnce(plate.corner == render::Corner::topRight ? "stats" : "legend", names);
    }
    if (placed.texts.size() < frame.texts.size()) addOnce("caption", names);
    return names;
}

std::vector<std::string> leftOut(const std::vector<Shot>& shots) {
    std::vector<std::string> names;
    for (const Shot& shot : shots)
        for (const std::string& name : shot.leftOut) addOnce(name, names);
    return names;
}

}  // namespace demos
