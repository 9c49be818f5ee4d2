#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/commands/commands.h"
#include "demos/commands/table.h"
#include "demos/film/exposure.h"
#include "demos/film/film_plan.h"
#include "demos/film/film_strip.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/quality.h"
#include "demos/player.h"
#include "demos/scene/complaints.h"
#include "render/encode/png.h"
#include "render/renderer.h"

namespace demos {
namespace {

constexpr double kMostSteps = 1e8;

/// The scene's own text would stand in every picture, six times the same.
FilmPlan planStrip(Options options) {
    const Quality& quality = qualityOf(options.quality);
    if (!options.size) options.size = PictureSize{quality.width / 2, quality.height / 2};
    FilmPlan plan = planFilm(options);
    const auto asked = [&](const char* name) {
        return std::find(options.show.begin(), options.show.end(), name) != options.show.end();
    };
    for (Panel& panel : plan.panels) {
        panel.overlays.text = asked("caption");
        panel.overlays.stats = asked("stats");
    }
    return plan;
}

/// After how many steps each picture is taken; rising.
std::vector<int> stepsOf(const FilmPlan& plan, const Options& options) {
    std::vector<int> steps;
    for (const double time : options.times) {
        if (time * plan.scene().hz > kMostSteps)
            throw Stop(Exit::usage,
                       fmt::format("--times {}: is more than {:.0f} steps away", time, kMostSteps));
        steps.push_back(static_cast<int>(std::lround(time * plan.scene().hz)));
        if (steps.size() > 1 && steps.back() == steps[steps.size() - 2])
            throw Stop(Exit::usage, fmt::format("--times {}: falls on the same step as the time "
                                                "before it; a step is {:.3g} s",
                                                time, 1.0 / plan.scene().hz));
    }
    if (!steps.empty()) return steps;
    if (options.moments > plan.frames)
        throw Stop(Exit::usage, fmt::format("--moments {}: the film has {} frames; ask for fewer "
                                            "moments or more --fps",
                                            options.moments, plan.frames));
    const double last = plan.frames - 1;
    for (int i = 0; i < options.moments; ++i) {
        const double share =
            options.moments > 1 ? static_cast<double>(i) / (options.moments - 1) : 0.5;
        steps.push_back(static_cast<int>(std::lround(share * last)) * plan.stepsPerFrame);
    }
    return steps;
}

std::string targetOf(const FilmPlan& plan, const Options& options) {
    const std::string pattern =
        options.outputs.empty() ? "output/{scene}/strip.png" : options.outputs.front();
    if (pattern == "-") return pattern;
    const std::string name = expandPattern(pattern, valuesOf(plan, 0));
    if (!name.ends_with(".png"))
        throw Stop(Exit::usage,
                   fmt::format("--output '{}': a strip ends in .png, or is -", printable(name)));
    return name;
}

render::Image drawStrip(const FilmPlan& plan, const StripLayout& layout,
                        const std::vector<int>& steps) {
    const Inks inks = inksOf(plan.panels.front().overlays.theme);
    render::Color ground = inks.ground;
    if (plan.alpha()) ground.a = 0.0f;
    render::Image paper = stripPaper(layout, ground);
    Player player(plan.scene(), plan.panels.front().overlays);
    render::Renderer renderer(plan.picture);
    int played = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double time = static_cast<double>(steps[i]) / plan.scene().hz;
        const auto seen = playTo(time, steps[i] - played, plan, player);
        played = steps[i];
        placeMoment(layout, static_cast<int>(i), exposed(seen, plan, renderer),
                    fmt::format("t = {:.2f} s", time), inks.ink, paper);
    }
    return paper;
}

}  // namespace

Exit stripCommand(const Options& options) {
    const FilmPlan plan = planStrip(options);
    const std::vector<int> steps = stepsOf(plan, options);
    const StripLayout layout =
        stripLayout(static_cast<int>(steps.size()), options.columns,
                    {plan.picture.width, plan.picture.height}, !options.clean);
    const std::string target = targetOf(plan, options);
    checkFree(target, options.overwrite);
    writeResult(target, render::encodePng(drawStrip(plan, layout, steps)));
    const Talk talk(options, target == "-");
    talk.json(fmt::format(R"({{"event":"done","file":{},"moments":{},"size":[{},{}]}})",
                          jsonString(target), layout.moments, layout.width, layout.height));
    talk.say(fmt::format("wrote {} ({} moments, {}x{})", printable(target), layout.moments,
                         layout.width, layout.height));
    talk.say(fmt::format("next: impulse render {} -o film.mp4", printable(options.scene())));
    return Exit::ok;
}

}  // namespace demos
