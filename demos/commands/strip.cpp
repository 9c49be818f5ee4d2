#include <fmt/format.h>

#include <charconv>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
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
#include "demos/options/picture_options.h"
#include "demos/snapshot/player.h"
#include "demos/text/complaints.h"
#include "demos/text/shell_word.h"
#include "render/overlay.h"
#include "render/renderer.h"

namespace demos {
namespace {

/// The size of each picture; on paper, only its ratio counts.
PictureSize pictureSize(const StripOptions& options) {
    const Quality& quality = qualityOf(options.quality);
    return options.size.value_or(PictureSize{quality.width / 2, quality.height / 2});
}

StripLayout layoutOf(const StripOptions& options) {
    const int moments =
        options.times.empty() ? options.moments : static_cast<int>(options.times.size());
    const Paper paper = paperOf(options);
    if (!paper.given())
        return stripLayout(moments, options.columns, pictureSize(options), !options.clean);
    return figureLayout(moments, options.columns, pictureSize(options), paper,
                        options.clean ? 0 : 1);
}

FilmPlan planOf(StripOptions options, const StripLayout& layout) {
    options.size = layout.picture;
    return planStrip(options);
}

std::string targetOf(const FilmPlan& plan, const StripOptions& options) {
    const std::string pattern =
        options.outputs.empty() ? "output/{scene}/strip.png" : options.outputs.front();
    if (pattern == "-") return pattern;
    const std::string name = expandPattern(pattern, valuesOf(plan, 0));
    if (!name.ends_with(".png"))
        throw Stop(Exit::usage,
                   fmt::format("--output '{}': a strip ends in .png, or is -", printable(name)));
    return name;
}

/// Type on paper keeps its size: where "t = 1.00 s" does not fit, the label is the time alone.
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
    std::vector<PictureFacts> facts;
    std::string incident;  // Player::incident
};

Strip drawStrip(const FilmPlan& plan, const StripLayout& layout, const std::vector<int>& steps,
                const Paper& paper) {
    Strip strip{stripPaper(layout, plan), {}, {}};
    const render::Color ink = inksOf(plan.panels.front().overlays.theme).ink;
    Player player(plan.scene(), plan.panels.front().overlays);
    render::Renderer renderer(plan.picture);
    int played = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double time = static_cast<double>(steps[i]) / plan.scene().hz;
        const auto seen = playTo(time, steps[i] - played, plan, player);
        played = steps[i];
        const int moment = static_cast<int>(i);
        const render::Image picture = exposed(seen, time, plan, renderer);
        strip.facts.push_back(factsOf(player, plan, seen.back(), paper));
        if (paper.given()) {
            placePicture(layout, moment, picture, strip.image);
            label(layout, moment, time, ink, strip.image);
        } else {
            placeMoment(layout, moment, picture, time, plan, strip.image);
        }
    }
    strip.incident = player.incident();
    return strip;
}

Exit strip(const StripOptions& options) {
    const Paper paper = paperOf(options);
    const StripLayout layout = layoutOf(options);
    const FilmPlan plan = planOf(options, layout);
    const std::vector<int> steps = stripSteps(plan, options);
    const std::string target = targetOf(plan, options);
    checkFigure({target}, options);
    if (paper.given()) checkNeeds(needsOf(plan, 1, {}), plan);
    const Strip strip = drawStrip(plan, layout, steps, paper);
    writeMoments({target, paper, plan, strip.facts}, strip.image, options);
    const Talk talk(options, target == "-");
    reportLeftOut(strip.facts, layout.picture, paper, talk);
    talk.json(fmt::format(R"({{"event":"done","file":{},"moments":{},"size":[{},{}]}})",
                          jsonString(target), layout.moments, layout.width, layout.height));
    talk.say(fmt::format("wrote {} ({} moments, {}x{})", printable(target), layout.moments,
                         layout.width, layout.height));
    reportCaptions({target}, options, talk);
    talk.say(fmt::format("next: impulse render {} -o film.mp4",
                         printable(shellWord(options.scene()))));
    if (!strip.incident.empty()) throw Stop(Exit::diverged, strip.incident);
    return Exit::ok;
}

/// Reads --times, which must increase.
std::vector<double> timesFrom(const std::vector<std::string>& texts) {
    std::vector<double> times;
    for (const std::string& text : texts) {
        double time = -1.0;
        const char* end = text.data() + text.size();
        const auto got = std::from_chars(text.data(), end, time);
        if (got.ec != std::errc{} || got.ptr != end || !(time >= 0.0 && time <= kLongest))
            refuse(fmt::format("--times '{}': must be times of 0 to 100000 s, with commas",
                               printable(text)));
        if (!times.empty() && time <= times.back())
            refuse(fmt::format("--times: {} does not come after {}; the times must increase", time,
                               times.back()));
        times.push_back(time);
    }
    if (times.size() > 100) refuse(fmt::format("--times: {} of them; at most 100", times.size()));
    return times;
}

Run addStrip(CLI::App& app) {
    const auto asked = std::make_shared<Asked<StripOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    CLI::Option* moments = app.add_option(
        "-n,--moments", options.moments,
        "number of moments, 1..100, evenly from the film's first frame to its last; default: 6");
    moments->type_name("N");
    app.add_option("--times", texts.times,
                   "their times in s, with commas, increasing; default: evenly spaced")
        ->type_name("S,S")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(moments);
    app.add_option("--columns", options.columns,
                   "moments per row; default: 0, up to six, rows as even as possible")
        ->type_name("N");
    app.add_option("-o,--output", options.outputs,
                   "a .png, patterns as for render, or - ; default: output/<scene>/strip.png")
        ->type_name("OUT")
        ->expected(1);
    addSeconds(app, options);
    addPicture(app, options, texts);
    app.get_option("--size")->description(
        "pixels of one picture, 1..16384 a side; default: half of the quality's");
    app.get_option("--clean")->description("draw no times below the pictures; default: off");
    addFigure(app, options, texts);
    addFeedback(app, options);
    return [asked](const std::string& commandLine) {
        StripOptions& given = settled(*asked, commandLine);
        checkRange("--moments", given.moments, 1, 100);
        checkRange("--columns", given.columns, 0, 100);
        given.times = timesFrom(asked->texts.times);
        return strip(given);
    };
}

}  // namespace

Command stripCommand() {
    return {"strip",
            "a row of moments as one picture, for paper or a slide",
            {"impulse strip stack", "impulse strip wall -n 8 --columns 4 --theme print -o wall.png",
             "impulse strip chain --times 0,0.5,1,2 --width 85mm -o figure.png"},
            addStrip};
}

}  // namespace demos
