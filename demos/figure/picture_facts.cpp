#include "demos/figure/picture_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/look/theme.h"
#include "demos/snapshot/colors.h"
#include "demos/snapshot/scale.h"
#include "demos/text/rounded.h"
#include "render/corners.h"
#include "render/palette.h"

namespace demos {
namespace {

/// Units per cm on paper; 0 if there is nothing to show or no paper.
double perCentimetre(const ArrowScale& scale, double pixelsPerMeter, const Paper& paper) {
    if (!(scale.metersPerUnit > 0.0) || !paper.given()) return 0.0;
    return paper.dpi / 2.54 / (scale.metersPerUnit * pixelsPerMeter);
}

/// "50 N s", or for pictures with different scales "50, 12 N s" or "50 N s, none".
template <class Value>
std::string listOf(const std::vector<PictureFacts>& facts, Value value, const std::string& unit) {
    std::vector<std::string> texts;
    bool all = true;
    for (const PictureFacts& fact : facts) all = all && value(fact) > 0.0;
    for (const PictureFacts& fact : facts) {
        const bool known = value(fact) > 0.0;
        texts.push_back(known ? fmt::format("{:g}", rounded(value(fact), 3)) : "none");
        if (known && !all) texts.back() += " " + unit;
    }
    const bool alike = std::all_of(texts.begin(), texts.end(),
                                   [&](const std::string& text) { return text == texts.front(); });
    if (alike) texts.resize(1);
    return fmt::format("{}{}", fmt::join(texts, ", "), all ? " " + unit : "");
}

template <class Value>
std::string arrowText(const char* what, const char* unit, const std::vector<PictureFacts>& facts,
                      Value value) {
    const bool known = std::any_of(facts.begin(), facts.end(),
                                   [&](const PictureFacts& fact) { return value(fact) > 0.0; });
    const bool onPaper = std::any_of(facts.begin(), facts.end(),
                                     [](const PictureFacts& fact) { return fact.onPaper; });
    if (!known) return onPaper ? "" : fmt::format("; {}", what);
    return fmt::format("; {}, 1 cm = {}", what, listOf(facts, value, unit));
}

bool hasArrow(const render::Frame& frame, const render::Color& color) {
    return std::any_of(frame.arrows.begin(), frame.arrows.end(), [&](const render::Arrow& arrow) {
        return arrow.color.r == color.r && arrow.color.g == color.g && arrow.color.b == color.b;
    });
}

/// The marks that need no scale.
std::string marksText(const Overlays& overlays) {
    std::string text;
    if (overlays.contacts) text += "; pink dots: contacts";
    if (overlays.normals) text += "; blue arrows: normals";
    if (overlays.annotate) text += "; labelled: the vectors of one contact or joint";
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

PictureFacts factsOf(const Player& player, const FilmPlan& plan, const render::Frame& frame,
                     const Paper& paper) {
    const Stage& stage = player.stage();
    const History& history = player.history();
    const double view = viewHeight(stage.scene.camera);
    const double meter =
        static_cast<double>(render::pixelsPerMeter(frame.camera, plan.picture.height));
    PictureFacts fact;
    fact.step = stage.world.report().step;
    fact.time = static_cast<double>(fact.step) / stage.scene.hz;
    fact.state = stage.world.hash();
    const double impulse = perCentimetre(ArrowScale(history.impulsePeak, view), meter, paper);
    const double nudge = perCentimetre(ArrowScale(history.nudgePeak, view), meter, paper);
    if (hasArrow(frame, render::impulseColor())) fact.impulse = impulse;
    if (hasArrow(frame, render::frictionColor())) fact.friction = impulse;
    if (hasArrow(frame, nudgeColor())) fact.nudge = 1e3 * nudge;
    fact.colorEnd = scaleEnd(plan.panels.front().overlays, history);
    fact.onPaper = paper.given();
    if (fact.onPaper) fact.leftOut = leftOut(frame, plan.picture.width, plan.picture.height);
    if (fact.onPaper && plan.panels.front().overlays.stats && !hasStats(frame))
        addOnce("stats", fact.leftOut);  // the first line took their place
    return fact;
}

std::string timesText(const std::vector<PictureFacts>& facts) {
    std::vector<std::string> times;
    bool coarse = true;  // in hundredths of a second
    for (const PictureFacts& fact : facts)
        coarse = coarse && std::abs(std::round(100.0 * fact.time) - 100.0 * fact.time) < 1e-6;
    for (const PictureFacts& fact : facts)
        times.push_back(coarse ? fmt::format("{:g}", fact.time) : fmt::format("{:.3f}", fact.time));
    const bool alike = std::all_of(times.begin(), times.end(),
                                   [&](const std::string& time) { return time == times.front(); });
    if (alike && !times.empty()) times.resize(1);
    return fmt::format("t = {} s", fmt::join(times, ", "));
}

std::string scalesText(const Overlays& overlays, const std::vector<PictureFacts>& facts) {
    std::string text;
    const auto impulse = [](const PictureFacts& fact) { return fact.impulse; };
    if (overlays.impulses)
        text += arrowText("red arrows: impulses along the normals", "N s", facts, impulse);
    if (overlays.friction)
        text += arrowText("orange arrows: friction", "N s", facts,
                          [](const PictureFacts& fact) { return fact.friction; });
    if (overlays.nudges)
        text += arrowText("violet arrows: nudges", "mm", facts,
                          [](const PictureFacts& fact) { return fact.nudge; });
    text += marksText(overlays);
    const std::string& by = overlays.colorBy;
    if (by == "speed" || by == "impulse")
        text += fmt::format("; colours: {}, 0 to {} (viridis)", by,
                            listOf(
                                facts, [](const PictureFacts& fact) { return fact.colorEnd; },
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

std::vector<std::string> leftOut(const std::vector<PictureFacts>& facts) {
    std::vector<std::string> names;
    for (const PictureFacts& fact : facts)
        for (const std::string& name : fact.leftOut) addOnce(name, names);
    return names;
}

}  // namespace demos
