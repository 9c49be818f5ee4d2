#include <fmt/format.h>

#include <utility>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/figure/figure_file.h"
#include "demos/figure/moments_figure.h"
#include "demos/film/composite.h"
#include "demos/film/exposure.h"
#include "demos/film/film_needs.h"
#include "demos/film/film_plan.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/state_files.h"
#include "demos/options/picture_options.h"
#include "demos/snapshot/player.h"
#include "demos/text/complaints.h"
#include "demos/text/shell_word.h"

namespace demos {
namespace {

/// The options of `impulse still`: one frame, by its time or its number.
struct StillOptions : Options {
    std::optional<double> time;  // s
    std::optional<int> frame;    // negative counts from the end
    std::string from;            // a state to continue from; empty: from time 0
};

/// The moment of the picture, as a number of steps.
struct Moment {
    int steps = 0;
    int frame = 0;      // of the film, the one shown at this time
    double time = 0.0;  // s
};

Moment momentOf(const FilmPlan& plan, const StillOptions& options) {
    Moment moment;
    if (options.time) {
        moment.steps = stepAt(*options.time, plan, "--time");
        const bool slow = !plan.slowSteps.empty();
        moment.frame = slow ? plan.frameAt(*options.time) : moment.steps / plan.stepsPerFrame;
    } else {
        const int asked = options.frame.value_or(-1);
        moment.frame = asked < 0 ? plan.frames + asked : asked;
        if (moment.frame < 0 || moment.frame >= plan.frames)
            throw Stop(Exit::usage,
                       fmt::format("--frame {}: the film has the frames 0 to {}, or -1 to -{}",
                                   asked, plan.frames - 1, plan.frames));
        moment.steps = plan.stepOf(moment.frame);
    }
    moment.time = static_cast<double>(moment.steps) / plan.scene().hz;
    return moment;
}

std::string targetOf(const FilmPlan& plan, const StillOptions& options, const Moment& moment) {
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

/// Returns the state's step. For the shutter, that must be before it opens.
int goOn(const FilmPlan& plan, const StillOptions& options, const Moment& moment, Player& player) {
    const long long step = goOnFrom(options.from, stateKindOf(plan.scene(), options),
                                    plan.panels.front().overlays, player);
    const int most = moment.steps - (plan.shutter.moments > 1 ? plan.stepsTo(moment.time) : 0);
    if (step > most)
        throw Stop(Exit::usage,
                   fmt::format("--from {}: is a state after step {}, and this picture is of step "
                               "{}; an earlier state is needed",
                               printable(options.from), step, moment.steps));
    return static_cast<int>(step);
}

Exit still(StillOptions options) {
    if (options.width) options.size = figureSize(options);
    const Paper paper = paperOf(options);
    FilmPlan plan = planFilm(options);
    const Moment moment = momentOf(plan, options);
    const std::string target = targetOf(plan, options, moment);
    checkFigure({target}, options);
    checkNeeds(needsOf(plan, 1, {}), plan);
    if (!options.from.empty()) {
        plan.states = std::filesystem::absolute(options.from).parent_path().string();
        plan.stateKind = stateKindOf(plan.scene(), options);
    }
    fitCameras(plan);
    Player player(plan.scene(), plan.panels.front().overlays);
    const int from = options.from.empty() ? 0 : goOn(plan, options, moment, player);
    const std::vector<render::Frame> seen =
        playTo(moment.time, moment.steps - from, plan, player);
    render::Renderer renderer(plan.picture);
    render::Image picture = exposed(seen, moment.time, plan, renderer);
    picture = withStrip(std::move(picture), plan, moment.time);
    const Talk talk(options, target == "-");
    const MomentsFigure figure{target, paper, plan, {factsOf(player, plan, seen.back(), paper)}};
    writeMoments(figure, picture, options);
    reportLeftOut(figure.facts, {plan.picture.width, plan.picture.height}, paper, talk);
    const std::string hash = hexText(player.stage().world.hash());
    talk.json(fmt::format(R"({{"event":"done","file":{},"time":{},"state":"{}"}})",
                          jsonString(target), numberText(moment.time), hash));
    talk.say(
        fmt::format("wrote {} (t = {:.3f} s, state {})", printable(target), moment.time, hash));
    reportCaptions({target}, options, talk);
    talk.say(fmt::format("next: impulse render {}", printable(shellWord(options.scene()))));
    player.stopIfIncident();
    return Exit::ok;
}

Run addStill(CLI::App& app) {
    const auto asked = std::make_shared<Asked<StillOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    CLI::Option* time = app.add_option("-t,--time", options.time, "time in s; default: the end");
    time->type_name("S");
    app.add_option("-f,--frame", options.frame,
                   "number of the frame in the film; negative: from the end; default: the last")
        ->type_name("N")
        ->excludes(time);
    app.add_option(
           "-o,--output", options.outputs,
           "a .png, patterns as for render, or - ; default: output/<scene>/still_<time>.png")
        ->type_name("OUT")
        ->expected(1);
    app.add_option("--from", options.from,
                   "continue from a state that 'impulse sim --states' has written; default: from "
                   "time 0")
        ->type_name("FILE");
    addSeconds(app, options);
    addPicture(app, options, texts);
    addFigure(app, options, texts);
    addFeedback(app, options);
    return [asked](const std::string& commandLine) {
        StillOptions& given = settled(*asked, commandLine);
        checkTime("--time", given.time);
        given.anyStep = given.time.has_value();
        return still(given);
    };
}

}  // namespace

Command stillCommand() {
    return {"still",
            "draw one frame",
            {"impulse still stack -t 2.0", "impulse still stack -f -1 -o last.png -q 4k",
             "impulse still my.toml -t 0.5 --show impulses --theme print"},
            addStill};
}

}  // namespace demos
