// A film's scene, and the frame rates and steps a second that fit together.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/load/load_scene.h"
#include "demos/text/put_text.h"

namespace demos {

std::string goodRates(int hz, int wanted) {
    constexpr int kMost = 240;
    std::vector<int> rates;
    for (int fps = 1; fps <= std::min(hz, kMost); ++fps)
        if (hz % fps == 0) rates.push_back(fps);
    std::stable_sort(rates.begin(), rates.end(), [wanted](int a, int b) {
        return std::abs(a - wanted) < std::abs(b - wanted);
    });
    rates.resize(std::min<std::size_t>(rates.size(), 6));
    std::sort(rates.begin(), rates.end());
    return fmt::format("{}", fmt::join(rates, " "));
}

int goodSteps(int hz, int fps) {
    constexpr int kFewest = 10, kMost = 100'000;  // steps a second that a scene may have
    int perFrame = std::max((hz + fps / 2) / fps, 1);
    while (perFrame * fps < kFewest) ++perFrame;
    while (perFrame * fps > kMost) --perFrame;
    return perFrame * fps;
}

SceneDescription sceneOf(const Options& options) {
    SceneDescription scene = loadScene(options.scene(), options.overrides);
    if (!options.quiet)
        for (const std::string& note : scene.notes) putError(note);
    if (options.seconds) scene.seconds = *options.seconds;
    return scene;
}

}  // namespace demos
