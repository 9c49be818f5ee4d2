// The meanings of the marks, with samples: an arrow of a round number of N s, a colour scale.
#include <fmt/format.h>

#include <algorithm>

#include "demos/look/theme.h"
#include "demos/snapshot/colors.h"
#include "demos/snapshot/frame_parts.h"
#include "demos/snapshot/scale.h"
#include "render/palette.h"

namespace demos {
namespace {

using render::Swatch;

void addScaledArrow(const char* name, const ArrowScale& scale, double factor, const char* unit,
                    const render::Color& color, std::vector<render::PlateRow>& rows) {
    render::PlateRow row{name, "none", Swatch::arrow, color};
    if (scale.sample > 0.0) {
        row.value = fmt::format("{:g} {}", factor * scale.sample, unit);
        row.meters = static_cast<float>(scale.sample * scale.metersPerUnit);
    }
    rows.push_back(std::move(row));
}

void addMeanings(const std::vector<ColorMeaning>& meanings, std::vector<render::PlateRow>& rows) {
    constexpr std::size_t kMost = 8;
    for (std::size_t i = 0; i < std::min(meanings.size(), kMost); ++i)
        rows.push_back({meanings[i].name, "", Swatch::dot, meanings[i].color});
    if (meanings.size() > kMost)
        rows.push_back({fmt::format("and {} more", meanings.size() - kMost), ""});
}

void addColors(const Moment& moment, std::vector<render::PlateRow>& rows) {
    const std::string& by = moment.overlays.colorBy;
    if (by == "body") return;
    const bool scaled = by == "speed" || by == "impulse";
    rows.push_back({scaled ? by : "colour", !scaled ? by : by == "speed" ? "m/s" : "N s"});
    if (!scaled) return addMeanings(colorMeanings(moment.stage, by), rows);
    render::PlateRow scale{"0", fmt::format("{:g}", scaleEnd(moment.overlays, moment.history))};
    scale.ramp = scaleRamp();
    rows.push_back(std::move(scale));
}

}  // namespace

void addLegend(const Moment& moment, render::Frame& frame) {
    const Overlays& show = moment.overlays;
    const double view = viewHeight(moment.stage.scene.camera);
    const ArrowScale impulse(moment.history.impulsePeak, view);
    const ArrowScale nudge(moment.history.nudgePeak, view);
    render::Plate plate;
    plate.corner = render::Corner::topLeft;
    const auto row = [&](const char* name, Swatch swatch, const render::Color& color) {
        plate.rows.push_back({name, "", swatch, color});
    };
    if (show.contacts) row("contact", Swatch::dot, render::contactColor());
    if (show.normals) row("normal", Swatch::arrow, render::normalColor());
    if (show.impulses)
        addScaledArrow("impulse", impulse, 1.0, "N s", render::impulseColor(), plate.rows);
    if (show.friction)
        addScaledArrow("friction", impulse, 1.0, "N s", render::frictionColor(), plate.rows);
    if (show.nudges) addScaledArrow("nudge", nudge, 1e3, "mm", nudgeColor(), plate.rows);
    if (show.joints) row("joint", Swatch::dot, render::jointColor());
    if (show.com) row("centre of mass", Swatch::quartered, render::fromHex(0x16181b));
    if (show.bounds) row("bounding box", Swatch::line, render::boundsColor());
    addColors(moment, plate.rows);
    frame.plates.push_back(std::move(plate));
}

}  // namespace demos
