#include "demos/figure/moments_figure.h"
#include "demos/options/picture_options.h"

#include <fmt/format.h>

#include "demos/figure/caption.h"
#include "demos/figure/figure_file.h"
#include "demos/film/quality.h"
#include "demos/text/table.h"
#include "render/encode/png.h"

namespace demos {
namespace {

Caption captionOf(const MomentsFigure& figure, PictureSize size, const Options& options) {
    const Overlays& overlays = figure.plan.panels.front().overlays;
    const SceneDescription& scene = figure.plan.scene();
    Caption caption(titleOf(scene) + ". " + timesText(figure.facts) +
                    scalesText(overlays, figure.facts));
    addFiles({figure.file}, size, figure.paper, caption);
    addLook(overlays, figure.facts, caption);
    addPhysics(scene, options, caption);
    addShots(figure.facts, caption);
    addProgram(options, caption);
    return caption;
}

}  // namespace

PictureSize figureSize(const Options& options) {
    const Quality& quality = qualityOf(options.quality);
    return figureSize(paperOf(options),
                      options.size.value_or(PictureSize{quality.width, quality.height}));
}

void writeMoments(const MomentsFigure& figure, const render::Image& picture,
                  const Options& options) {
    const Caption caption = captionOf(figure, {picture.width, picture.height}, options);
    const int dpi = figure.paper.given() ? figure.paper.dpi : 0;
    writeFigure({{figure.file, render::encodePng(picture, dpi)}}, caption.text(), options,
                existingFiles(options.overwrite));
}

void reportLeftOut(const std::vector<PictureFacts>& facts, PictureSize picture, const Paper& paper,
                 const Talk& talk) {
    const std::vector<std::string> names = leftOut(facts);
    if (names.empty()) return;
    talk.mention(fmt::format(
        "{}: no room in a picture of {:.0f} x {:.0f} mm, left out; use a larger --width or a "
        "higher --size",
        fmt::join(names, ", "), paper.millimetresOf(picture.width),
        paper.millimetresOf(picture.height)));
}

}  // namespace demos
