#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/commands/table.h"
#include "demos/film/exposure.h"
#include "demos/film/film_plan.h"
#include "demos/film/film_strip.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/strip_plan.h"
#include "demos/player.h"
#include "demos/scene/complaints.h"
#include "render/encode/png.h"
#include "render/renderer.h"

namespace demos {
namespace {

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
    render::Image paper = stripPaper(layout, plan);
    Player player(plan.scene(), plan.panels.front().overlays);
    render::Renderer renderer(plan.picture);
    int played = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double time = static_cast<double>(steps[i]) / plan.scene().hz;
        const auto seen = playTo(time, steps[i] - played, plan, player);
        played = steps[i];
        placeMoment(layout, static_cast<int>(i), exposed(seen, plan, renderer), time, plan, paper);
    }
    return paper;
}

}  // namespace

Exit stripCommand(const Options& options) {
    const FilmPlan plan = planStrip(options);
    const std::vector<int> steps = stripSteps(plan, options);
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
