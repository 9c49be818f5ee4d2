// impulse list --gallery: a frame of every scene in one picture.

#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/commands/table.h"
#include "demos/film/exposure.h"
#include "demos/film/film_plan.h"
#include "demos/film/film_strip.h"
#include "demos/film/outputs.h"
#include "demos/film/poster.h"
#include "demos/film/progress.h"
#include "demos/player.h"
#include "demos/report/inks.h"
#include "demos/scene/complaints.h"
#include "demos/theme.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr PictureSize kTile{480, 270};

std::string targetOf(const Options& options) {
    const std::string target =
        options.outputs.empty() ? "output/gallery.png" : options.outputs.front();
    if (target != "-" && !target.ends_with(".png"))
        throw Stop(Exit::usage, fmt::format("--output '{}': a gallery ends in .png, or is -",
                                            printable(target)));
    return target;
}

std::vector<std::string> scenesOf(const Options& options) {
    if (!options.scenes.empty()) return options.scenes;
    std::vector<std::string> names;
    for (const SceneDescription& scene : scenesByGroup()) names.push_back(scene.name);
    return names;
}

FilmPlan planTile(const std::string& scene, Options options) {
    options.scenes = {scene};
    if (!options.size) options.size = kTile;
    FilmPlan plan = planFilm(options);
    for (Panel& panel : plan.panels) panel.overlays.text = false;
    return plan;
}

/// The frame that stands for the scene: its poster.
render::Image drawTile(const FilmPlan& plan, const Options& options) {
    const int frame = posterFrame(plan, options);
    Player player(plan.scene(), plan.panels.front().overlays);
    const auto seen = playTo(plan.timeOf(frame), frame * plan.stepsPerFrame, plan, player);
    render::Renderer renderer(plan.picture);
    return exposed(seen, plan, renderer);
}

}  // namespace

Exit galleryCommand(const Options& options) {
    const std::string target = targetOf(options);
    checkFree(target, options.overwrite);
    const std::vector<std::string> scenes = scenesOf(options);
    const int count = static_cast<int>(scenes.size());
    const StripLayout layout = stripLayout(count, options.columns, options.size.value_or(kTile), true);
    const Inks inks = inksOf("studio");
    render::Image paper = stripPaper(layout, inks.ground);
    const Talk talk(options, target == "-");
    for (int i = 0; i < count; ++i) {
        const FilmPlan plan = planTile(scenes[i], options);
        placeMoment(layout, i, drawTile(plan, options), plan.scene().name, inks.ink, paper);
    }
    writeResult(target, render::encodePng(paper));
    talk.json(fmt::format(R"({{"event":"done","file":{},"scenes":{},"size":[{},{}]}})",
                          jsonString(target), count, layout.width, layout.height));
    talk.say(fmt::format("wrote {} ({} scenes, {}x{})", printable(target), count, layout.width,
                         layout.height));
    talk.say("next: impulse list NAME, or impulse render NAME");
    return Exit::ok;
}

}  // namespace demos
