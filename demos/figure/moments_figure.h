/// One moment of a scene, or several, as a figure with its caption: impulse still and strip.
#pragma once
#include <string>
#include <vector>

#include "demos/figure/picture_facts.h"
#include "demos/film/progress.h"
#include "render/image.h"

namespace demos {

/// Pixels of a figure: --width, and the ratio of --size or of the quality.
PictureSize figureSize(const Options& options);

struct MomentsFigure {
    std::string file;  // or "-"
    Paper paper;
    const FilmPlan& plan;
    std::vector<PictureFacts> facts;
};

/// Writes the PNG and its caption. Throws render::Error.
void writeMoments(const MomentsFigure& figure, const render::Image& picture,
                  const Options& options);

/// Reports on standard error what has no room in a figure, where letters do not shrink.
void reportLeftOut(const std::vector<PictureFacts>& facts, PictureSize picture, const Paper& paper,
                 const Talk& talk);

}  // namespace demos
