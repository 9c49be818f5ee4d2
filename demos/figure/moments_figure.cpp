#include "demos/figure/moments_figure.h"

#include <fmt/format.h>

#include "demos/figure/caption.h"
#include "demos/figure/figure_file.h"
#include "demos/film/quality.h"
#include "render/encode/png.h"

namespace demos {
namespace {

Caption captionOf(const MomentsFigure& figure, PictureSize size, const Options& options) {
    const Overlays& overlays = figure.plan.panels.front().overlays;
    const SceneDescription& scene = figure.plan.scene();
    Caption caption(titleOf(scene) + ". " + timesText(figure.shots) +
                    scalesText(overlays, figure.shots));
    addFiles({figure.file}, size, figure.paper, caption);
    addLook(overlays, figure.shots, caption);
    addPhysics(scene, options, caption);
    addShots(figure.shots, caption);
    addProgram(options, caption);
    return caption;
}

}  // namespace

Options figureOptions(Options options) {
    if (!options.width) return options;
    const Quality& quality = qualityOf(options.quality);
    options.size = figureSize(paperOf(options),
                              options.size.value_or(PictureSize{quality.width, quality.height}));
    return options;
}

void writeMoments(const MomentsFigure& figure, const render::Image& picture,
                  const Options& options) {
    const Caption caption = captionOf(figure, {picture.width, picture.height}, options);
    const int dpi = figure.paper.given() ? figure.paper.dpi : 0;
    writeFigure({{figure.file, render::encodePng(picture, dpi)}}, caption.text(), options);
}

void tellLeftOut(const std::vector<Shot>& shots, PictureSize picture, const Paper& paper,
                 const Talk& talk) {
    const std::vector<std::string> names = leftOut(shots);
    if (names.empty()) return;
    talk.mention(fmt::format(
        "{}: no room in a picture of {:.0f} x {:.0f} mm, left out; use a larger --width or a "
        "higher --size",
        fmt::join(names, ", "), paper.millimetresOf(picture.width),
        paper.millimetresOf(picture.height)));
}

}  // namespace demos
