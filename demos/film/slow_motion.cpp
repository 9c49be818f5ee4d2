#include "demos/film/slow_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace demos {
namespace {

/// From here on the run passes at one speed.
struct Span {
    double run = 0.0, film = 0.0;  // s
    double slow = 1.0;

    double filmAt(double time) const { return film + (time - run) / slow; }
    double runAt(double time) const { return run + (time - film) * slow; }
};

std::vector<Span> spansOf(const SceneDescription& scene) {
    std::vector<Span> spans{{}};
    for (const Section& section : scene.sections) {
        const double at = std::min(section.at, scene.seconds);
        spans.push_back({at, spans.back().filmAt(at), section.slow});
    }
    return spans;
}

}  // namespace

bool hasSlowMotion(const SceneDescription& scene) {
    return std::ranges::any_of(scene.sections, [&scene](const Section& section) {
        return section.slow != 1.0 && section.at < scene.seconds;
    });
}

double filmTimeAt(double time, const SceneDescription& scene) {
    const std::vector<Span> spans = spansOf(scene);
    const auto after = std::ranges::upper_bound(spans, time, {}, &Span::run);
    return after == spans.begin() ? time : std::prev(after)->filmAt(time);
}

std::vector<int> stepsOfFrames(const SceneDescription& scene, int fps, int frames) {
    const std::vector<Span> spans = spansOf(scene);
    const int last = static_cast<int>(std::lround(scene.seconds * scene.hz));
    std::vector<int> steps;
    std::size_t span = 0;
    for (int frame = 0; frame < frames; ++frame) {
        const double time = static_cast<double>(frame) / fps;
        while (span + 1 < spans.size() && spans[span + 1].film <= time) ++span;
        const double step = spans[span].runAt(time) * scene.hz;
        steps.push_back(std::min(static_cast<int>(step + 1e-6), last));  // 0.1 * 60 may be below 6
    }
    steps.push_back(last);
    return steps;
}

std::vector<std::string> jerkySections(const SceneDescription& scene, int fps) {
    std::vector<std::string> lines;
    for (const Section& section : scene.sections) {
        const double framesAStep = fps / (section.slow * scene.hz);
        if (framesAStep < 1.0 + 1e-9 || section.slow == 1.0 || section.at >= scene.seconds) continue;
        const int smooth = fps * static_cast<int>(std::ceil(1.0 / section.slow - 1e-9));
        lines.push_back(fmt::format("the section at {:.4g} s: slow = {:.4g} shows each step in {:.4g} frames; "
                                    "with --set world.hz={} each frame has its own",
                                    section.at, section.slow, framesAStep, smooth));
    }
    return lines;
}

}  // namespace demos
