#include "demos/film/strip_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/film/quality.h"
#include "demos/look/inks.h"
#include "demos/text/stop.h"

namespace demos {

FilmPlan planStrip(StripOptions options) {
    options.anyStep = !options.times.empty();
    options.plotBelow = false;  // a row of moments has no single time for a cursor
    const Quality& quality = qualityOf(options.quality);
    if (!options.size) options.size = PictureSize{quality.width / 2, quality.height / 2};
    FilmPlan plan = planPictures(options);
    const auto asked = [&](const char* name) {
        return std::find(options.show.begin(), options.show.end(), name) != options.show.end();
    };
    for (Panel& panel : plan.panels) {
        panel.overlays.text = asked("caption");
        panel.overlays.stats = asked("stats");
    }
    return plan;
}

std::vector<int> stripSteps(const FilmPlan& plan, const StripOptions& options) {
    std::vector<int> steps;
    for (const double time : options.times) {
        steps.push_back(stepAt(time, plan, "--times"));
        if (steps.size() > 1 && steps.back() == steps[steps.size() - 2])
            throw Stop(Exit::usage, fmt::format("--times {}: falls on the same step as the time "
                                                "before it; a step is {:.3g} s",
                                                time, 1.0 / plan.scene().hz));
    }
    if (!steps.empty()) return steps;
    const int frames = plan.stepOf(plan.frames) / plan.stepsPerFrame;  // without slow motion
    if (options.moments > frames)
        throw Stop(Exit::usage, fmt::format("--moments {}: the film has {} frames; ask for fewer "
                                            "moments or more --fps",
                                            options.moments, frames));
    const double last = frames - 1;
    for (int i = 0; i < options.moments; ++i) {
        const double share =
            options.moments > 1 ? static_cast<double>(i) / (options.moments - 1) : 0.5;
        steps.push_back(static_cast<int>(std::lround(share * last)) * plan.stepsPerFrame);
    }
    return steps;
}

render::Image stripPaper(const StripLayout& layout, const FilmPlan& plan) {
    render::Color ground = inksOf(plan.panels.front().overlays.theme).ground;
    if (plan.alpha()) ground.a = 0.0f;
    return stripPaper(layout, ground);
}

void placeMoment(const StripLayout& layout, int moment, const render::Image& picture, double time,
                 const FilmPlan& plan, render::Image& paper) {
    placeMoment(layout, moment, picture, fmt::format("t = {:.2f} s", time),
                inksOf(plan.panels.front().overlays.theme).ink, paper);
}

}  // namespace demos
