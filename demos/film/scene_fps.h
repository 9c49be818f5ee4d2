/// Defaults for a scene's film: a frame rate that its steps allow, an opaque theme.
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

/// Sets options that were not given, for an opaque film of the scene: a rate that its steps allow,
/// and a theme with a ground if the scene's theme has none.
inline void suitFilm(const SceneDescription& scene, Options& options) {
    if (!options.fps) options.fps = fpsUpTo(qualityOf(options.quality).fps, scene.hz);
    if (options.theme.empty() && scene.look.theme == "transparent") options.theme = "studio";
}

}  // namespace demos
