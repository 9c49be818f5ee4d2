/// A frame rate that a scene's steps allow, and what else suits its film.
#pragma once
#include "demos/film/quality.h"
#include "demos/options/options.h"
#include "demos/scene/description.h"

namespace demos {

/// The largest rate up to `wanted` frames a second that divides `hz` steps a second; both are
/// positive.
constexpr int fpsUpTo(int wanted, int hz) {
    int fps = wanted < hz ? wanted : hz;
    while (hz % fps != 0) --fps;
    return fps;
}

/// What was not asked for, for an opaque film of the scene: a rate that its steps allow, and a
/// ground to stand on where the scene's theme has none.
inline void suitFilm(const SceneDescription& scene, Options& options) {
    if (!options.fps) options.fps = fpsUpTo(qualityOf(options.quality).fps, scene.hz);
    if (options.theme.empty() && scene.look.theme == "transparent") options.theme = "studio";
}

}  // namespace demos
