#include <fmt/format.h>

#include <utility>

#include "demos/commands/commands.h"
#include "demos/figure/figure_file.h"
#include "demos/figure/moments_figure.h"
#include "demos/film/exposure.h"
#include "demos/film/film_needs.h"
#include "demos/film/film_plan.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/screen.h"
#include "demos/player.h"
#include "demos/scene/complaints.h"
#include "demos/shell_word.h"

namespace demos {
namespace {

/// Which picture: after so many steps.
struct Moment {
    int steps = 0;
    int frame = 0;      // of the film, the one shown at this time
    double time = 0.0;  // s
};

Moment momentOf(const FilmPlan& plan, const Options& options) {
    Moment moment;
    if (options.time) {
        moment.steps = stepAt(*options.time, plan, "--time");
        moment.frame = moment.steps / plan.stepsPerFrame;
    } else {
        const int asked = options.frame.value_or(-1);
        moment.frame = asked < 0 ? plan.frames + asked : asked;
        if (moment.frame < 0 || moment.frame >= plan.frames)
            throw Stop(Exit::usage,
                       fmt::format("--frame {}: the film has the frames 0 to {}, or -1 to -{}",
                                   asked, plan.frames - 1, plan.frames));
        moment.steps = moment.frame * plan.stepsPerFrame;
    }
    moment.time = static_cast<double>(moment.steps) / plan.scene().hz;
    return moment;
}

std::string targetOf(const FilmPlan& plan, const Options& options, const Moment& moment) {
    const std::string pattern =
        options.outputs.empty() ? "output/{scene}/still_{time}.png" : options.outputs.front();
    if (pattern == "-") return pattern;
    const std::string name =
        expandPattern(pattern, {moment.frame, moment.time, plan.name, plan.quality});
    if (!name.ends_with(".png"))
        throw Stop(Exit::usage,
                   fmt::format("--output '{}': a still ends in .png, or is -", printable(name)));
    return name;
}

}  // namespace

Exit stillCommand(const Options& asked) {
    const Options options = figureOptions(asked);
    const Paper paper = paperOf(options);
    const FilmPlan plan = planFilm(options);
    const Moment moment = momentOf(plan, options);
    const std::string target = targetOf(plan, options, moment);
    checkFigure({target}, options);
    checkNeeds(needsOf(plan, 1, {}), plan);
    Player player(plan.scene(), plan.panels.front().overlays);
    const std::vector<render::Frame> seen = playTo(moment.time, moment.steps, plan, player);
    render::Renderer renderer(plan.picture);
    render::Image picture = exposed(seen, plan, renderer);
    picture = withStrip(std::move(picture), plan, moment.time);
    const Talk talk(options, target == "-");
    const MomentsFigure figure{target, paper, plan, {shotOf(player, plan, seen.back(), paper)}};
    writeMoments(figure, picture, options);
    tellLeftOut(figure.shots, {plan.picture.width, plan.picture.height}, paper, talk);
    const std::string hash = hexText(player.stage().world.hash());
    talk.json(fmt::format(R"({{"event":"done","file":{},"time":{},"state":"{}"}})",
                          jsonString(target), numberText(moment.time), hash));
    talk.say(
        fmt::format("wrote {} (t = {:.3f} s, state {})", printable(target), moment.time, hash));
    tellCaptions({target}, options, talk);
    talk.say(fmt::format("next: impulse render {}", printable(shellWord(options.scene()))));
    return Exit::ok;
}

}  // namespace demos
