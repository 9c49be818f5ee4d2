// The caption with its heading, and on paper the line that replaces statistics without room.
#include <fmt/format.h>

#include "demos/look/inks.h"
#include "demos/snapshot/frame_parts.h"
#include "demos/text/plural.h"

namespace demos {
namespace {

constexpr float kCaptionSize = 24.0f;

/// That of the last section with a caption, under the section's name; before, the scene's title.
render::Text captionAt(const SceneDescription& scene, double time) {
    render::Text caption{scene.title, render::Corner::bottomLeft, kCaptionSize};
    caption.plate = true;
    for (const Section& section : scene.sections) {
        if (section.at > time + 1e-9 || section.caption.empty()) continue;
        const FormulaCaption& formulas = section.formulaCaption;
        caption.text = formulas.line.empty() ? section.caption : formulas.line;
        caption.formulas = formulas.formulas;
        caption.heading = section.name;
    }
    return caption;
}

}  // namespace

void addTexts(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const Overlays& show = moment.overlays;
    const int substeps = stage.world.settings().substeps;
    if (show.stats && show.clock && show.pixelsPerPoint > 0.0)
        frame.texts.push_back(
            {fmt::format("t = {:.3f} s   {}   {}, {}", moment.time,
                         plural(stage.bodiesNow(), "body", "bodies"), stage.scene.preset,
                         plural(substeps, "sub-step", "sub-steps")),
             render::Corner::topLeft, 18.0f});
    render::Text caption = captionAt(stage.scene, moment.time);
    if (!caption.text.empty()) frame.texts.push_back(std::move(caption));
}

void colorHeadings(render::Frame& frame) {
    Inks inks;
    inks.ink = frame.look.ink;
    inks.ground = frame.look.plate;
    for (render::Text& text : frame.texts) text.headingColor = labelColor(0, inks);
}

}  // namespace demos
