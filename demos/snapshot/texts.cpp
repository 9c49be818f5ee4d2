// The first line, and the caption.
#include <fmt/format.h>

#include "demos/snapshot/frame_parts.h"
#include "demos/text/plural.h"

namespace demos {
namespace {

std::string captionAt(const SceneDescription& scene, double time) {
    std::string caption = scene.title;
    for (const Section& section : scene.sections)
        if (section.at <= time + 1e-9 && !section.caption.empty()) caption = section.caption;
    return caption;
}

}  // namespace

void addTexts(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const int bodies = stage.bodiesNow();
    const int substeps = stage.world.settings().substeps;
    // Statistics have the same; on paper they may have no room.
    const bool said = moment.overlays.stats && moment.overlays.pixelsPerPoint <= 0.0;
    if (moment.overlays.clock && !said)
        frame.texts.push_back({fmt::format("t = {:.3f} s   {}   {}, {}", moment.time,
                                           plural(bodies, "body", "bodies"), stage.scene.preset,
                                           plural(substeps, "sub-step", "sub-steps")),
                               render::Corner::topLeft, 18.0f, render::Text{}.color});
    const std::string caption = captionAt(stage.scene, moment.time);
    if (caption.empty()) return;
    if (moment.overlays.plate)
        frame.plates.push_back({render::Corner::bottomLeft, render::Plate{}.size, {{caption, ""}}});
    else
        frame.texts.push_back({caption, render::Corner::bottomLeft, 26.0f, render::Text{}.color});
}

}  // namespace demos
