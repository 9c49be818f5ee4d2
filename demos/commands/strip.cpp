#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/figure/figure_file.h"
#include "demos/figure/figure_grid.h"
#include "demos/figure/moments_figure.h"
#include "demos/film/exposure.h"
#include "demos/film/film_needs.h"
#include "demos/film/film_plan.h"
#include "demos/film/film_strip.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/quality.h"
#include "demos/film/strip_plan.h"
#include "demos/player.h"
#include "demos/scene/complaints.h"
#include "demos/shell_word.h"
#include "render/overlay.h"
#include "render/renderer.h"

namespace demos {
namespace {

/// The pictures' size, or on paper their ratio.
PictureSize pictureSize(const Options& options) {
    const Quality& quality = qualityOf(options.quality);
    return options.size.value_or(PictureSize{quality.width / 2, quality.height / 2});
}

StripLayout layoutOf(const Options& options) {
    const int moments =
        options.times.empty() ? options.moments : static_cast<int>(options.times.size());
    const Paper paper = paperOf(options);
    if (!paper.given())
        return stripLayout(moments, options.columns, pictureSize(options), !options.clean);
    return figureLayout(moments, options.columns, pictureSize(options), paper,
                        options.clean ? 0 : 1);
}

FilmPlan planOf(Options options, const StripLayout& layout) {
    options.size = layout.picture;
    return planStrip(options);
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

/// Letters on paper do not shrink; where there is no room for all, the time says enough.
void label(const StripLayout& layout, int moment, double time, const render::Color& ink,
           render::Image& paper) {
    if (layout.label == 0) return;
    const std::string whole = fmt::format("t = {:.2f} s", time);
    const float room = static_cast<float>(layout.picture.width);
    const bool fits = render::textWidth(whole, static_cast<float>(layout.label)) <= room;
    placeLines(layout, moment, {fits ? whole : fmt::format("{:.2f} s", time)},
               render::Anchor::middle, ink, paper);
}

struct Strip {
    render::Image image;
    std::vector<Shot> shots;
};

Strip drawStrip(const FilmPlan& plan, const StripLayout& layout, const std::vector<int>& steps,
                const Paper& paper) {
    Strip strip{stripPaper(layout, plan), {}};
    const render::Color ink = inksOf(plan.panels.front().overlays.theme).ink;
    Player player(plan.scene(), plan.panels.front().overlays);
    render::Renderer renderer(plan.picture);
    int played = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double time = static_cast<double>(steps[i]) / plan.scene().hz;
        const auto seen = playTo(time, steps[i] - played, plan, player);
        played = steps[i];
        const int moment = static_cast<int>(i);
        const render::Image picture = exposed(seen, plan, renderer);
        strip.shots.push_back(shotOf(player, plan, seen.back(), paper));
        if (paper.given()) {
            placePicture(layout, moment, picture, strip.image);
            label(layout, moment, time, ink, strip.image);
        } else {
            placeMoment(layout, moment, picture, time, plan, strip.image);
        }
    }
    return strip;
}

}  // namespace

Exit stripCommand(const Options& options) {
    const Paper paper = paperOf(options);
    const StripLayout layout = layoutOf(options);
    const FilmPlan plan = planOf(options, layout);
    const std::vector<int> steps = stripSteps(plan, options);
    const std::string target = targetOf(plan, options);
    checkFigure({target}, options);
    if (paper.given()) checkNeeds(needsOf(plan, 1, {}), plan);
    const Strip strip = drawStrip(plan, layout, steps, paper);
    writeMoments({target, paper, plan, strip.shots}, strip.image, options);
    const Talk talk(options, target == "-");
    tellLeftOut(strip.shots, layout.picture, paper, talk);
    talk.json(fmt::format(R"({{"event":"done","file":{},"moments":{},"size":[{},{}]}})",
                          jsonString(target), layout.moments, layout.width, layout.height));
    talk.say(fmt::format("wrote {} ({} moments, {}x{})", printable(target), layout.moments,
                         layout.width, layout.height));
    tellCaptions({target}, options, talk);
    talk.say(fmt::format("next: impulse render {} -o film.mp4",
                         printable(shellWord(options.scene()))));
    return Exit::ok;
}

}  // namespace demos
