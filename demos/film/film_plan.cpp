#include "demos/film/film_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/film/plot_strip.h"
#include "demos/film/quality.h"
#include "demos/film/slow_motion.h"
#include "demos/load/load_scene.h"
#include "demos/options/picture_options.h"
#include "demos/play/motion_camera.h"
#include "demos/scene/reader.h"
#include "demos/text/hex_text.h"
#include "demos/text/program_bytes.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"
#include "demos/text/version.h"

namespace demos {
namespace {

int stepsPerFrame(int hz, int fps) {
    if (hz % fps != 0)
        throw Stop(Exit::usage,
                   fmt::format("--fps {}: the scene steps {} times a second, which must be a "
                               "multiple; good: {}, or --set world.hz={}",
                               fps, hz, goodRates(hz, fps), goodSteps(hz, fps)));
    return hz / fps;
}

int frameCount(double seconds, int fps) {
    const double frames = std::max(std::round(seconds * fps), 1.0);
    if (frames > kMostFrames)
        throw Stop(Exit::usage, fmt::format("a film of {} s at {} frames a second has {:.0f} "
                                            "frames; at most {} can be written",
                                            seconds, fps, frames, kMostFrames));
    return static_cast<int>(frames);
}

/// Two to four panels are twice as large where they could not be read otherwise: in a draft.
PictureSize usualSize(const Quality& quality, std::size_t panels) {
    constexpr int kLeastPanel = 320;  // pixels, of its width
    const bool small = panels > 1 && panels <= 4 && quality.width / 2 < kLeastPanel;
    return small ? PictureSize{2 * quality.width, 2 * quality.height}
                 : PictureSize{quality.width, quality.height};
}

}  // namespace

Overlays overlaysOf(const SceneDescription& scene, const Options& options) {
    Overlays overlays;
    for (const std::string& name : scene.look.show) switchOn(overlays, name);
    for (const std::string& name : options.show) switchOn(overlays, name);
    overlays.theme = themeOf(scene, options);
    overlays.pixelsPerPoint = paperOf(options).pixelsPerPoint();
    overlays.colorBy = options.colorBy.empty() ? scene.look.colorBy : options.colorBy;
    overlays.colorMax = scene.look.colorMax;
    overlays.ghostEvery = scene.look.ghostEvery;
    if (options.clean) overlays.text = overlays.stats = overlays.ids = false;
    return overlays;
}

int stepAt(double time, const FilmPlan& plan, const char* option) {
    constexpr double kMostSteps = 1e8;
    const double steps = time * plan.scene().hz;
    if (steps > kMostSteps)
        throw Stop(Exit::usage,
                   fmt::format("{} {}: is more than {:.0f} steps away", option, time, kMostSteps));
    return static_cast<int>(std::lround(steps));
}

FilmPlan planFilm(std::vector<Panel> panels, bool strip, const Options& options) {
    const Quality& quality = qualityOf(options.quality);
    FilmPlan plan;
    plan.panels = std::move(panels);
    const SceneDescription& scene = plan.scene();
    plan.name = scene.name;
    for (Panel& panel : plan.panels) panel.overlays = overlaysOf(panel.scene, options);
    plan.quality = quality.name;
    plan.fps = options.fps.value_or(quality.fps);
    plan.stepsPerFrame =
        options.anyStep ? std::max(scene.hz / plan.fps, 1) : stepsPerFrame(scene.hz, plan.fps);
    for (const Panel& panel : plan.panels)
        if (!options.anyStep) stepsPerFrame(panel.scene.hz, plan.fps);
    plan.frames = frameCount(scene.seconds, plan.fps);
    const PictureSize size = options.size.value_or(usualSize(quality, plan.panels.size()));
    plan.layout = panelLayout(static_cast<int>(plan.panels.size()), strip, size.width, size.height);
    if (strip && options.width)
        plan.layout = layoutWithStrip(size.width, size.height, chartBelow(paperOf(options)).height);
    plan.picture.width = plan.layout.panels.front().width;
    plan.picture.height = plan.layout.panels.front().height;
    const bool parted = strip || plan.panels.size() > 1;
    if (parted && std::min(plan.picture.width, plan.picture.height) < 2)
        throw Stop(Exit::usage, fmt::format("--size {}x{}: too small for a picture of several "
                                            "parts; try 640x360",
                                            size.width, size.height));
    plan.picture.samples = options.samples.value_or(quality.samples);
    plan.picture.finish = quality.finish;
    plan.picture.reproducible = options.reproducible;
    plan.picture.wholeFrames = options.wholeFrames;
    plan.shutter.moments = options.blur.value_or(quality.moments);
    plan.shutter.open = options.shutter.value_or(plan.shutter.open);
    plan.picture.context = render::contextCalled(options.context);
    return plan;
}

FilmPlan planFilm(const Options& options) {
    Panel panel;
    panel.scene = sceneOf(options);
    const bool strip = overlaysOf(panel.scene, options).plot && options.plotBelow;
    FilmPlan plan = planFilm({std::move(panel)}, strip, options);
    if (!options.anyStep && hasSlowMotion(plan.scene())) {
        plan.frames = frameCount(filmTimeAt(plan.scene().seconds, plan.scene()), plan.fps);
        plan.slowSteps = stepsOfFrames(plan.scene(), plan.fps, plan.frames);
    }
    if (strip) addStrip({playedChart(plan.scene())}, plan, paperOf(options));
    return plan;
}

void fitCameras(FilmPlan& plan) {
    if (plan.panels.size() == 1 && !plan.states.empty())
        readCamera(plan.states, plan.stateKind, plan.panels.front().scene);
    std::vector<SceneDescription*> scenes;
    for (Panel& panel : plan.panels) scenes.push_back(&panel.scene);
    fitToMotion(scenes);
}

FilmPlan planPictures(const Options& options) {
    FilmPlan plan = planFilm(options);
    fitCameras(plan);
    return plan;
}

int FilmPlan::stepOf(int frame) const {
    if (slowSteps.empty() || frame < 0) return frame * stepsPerFrame;
    return slowSteps[static_cast<std::size_t>(std::min(frame, frames))];
}

double FilmPlan::timeOf(int frame) const {
    if (slowSteps.empty()) return static_cast<double>(frame) / fps;
    return static_cast<double>(stepOf(frame)) / scene().hz;
}

double FilmPlan::filmTimeAt(double time) const {
    return slowSteps.empty() ? time : demos::filmTimeAt(time, scene());
}

int FilmPlan::firstFrameAt(double time) const {
    if (slowSteps.empty()) return static_cast<int>(std::ceil(time * fps - 1e-6));
    const double step = time * scene().hz - 1e-6;
    return static_cast<int>(std::ranges::lower_bound(slowSteps, step) - slowSteps.begin());
}

int FilmPlan::frameAt(double time) const {
    if (slowSteps.empty())
        return std::clamp(static_cast<int>(std::lround(time * fps)), 0, frames - 1);
    const int after = std::clamp(firstFrameAt(time), 0, frames - 1), before = std::max(after - 1, 0);
    return time - timeOf(before) < timeOf(after) - time ? before : after;
}

int FilmPlan::stepsTo(double time) const {
    const int frame = std::max(frameAt(time), 1);
    return stepOf(frame) - stepOf(frame - 1);
}

bool FilmPlan::alpha() const {
    return std::any_of(panels.begin(), panels.end(),
                       [](const Panel& panel) { return panel.overlays.theme == "transparent"; });
}

std::uint64_t fingerprintOf(const FilmPlan& plan, const Options& options) {
    TextHash hash;
    hash.add(kVersion);
    hash.add(hexText(programHash()));
    hash.add(sceneText(options.scene()));
    for (const std::string& file : plan.scene().files)
        hash.add(readSceneFile(file, "a file of the scene", kMostPartBytes));
    for (const std::string& text : options.overrides) hash.add(text);
    hash.add(fmt::format("{}x{} {}x{} {} {} {} {} {}", plan.layout.width, plan.layout.height,
                         plan.picture.width, plan.picture.height, plan.picture.samples,
                         plan.picture.reproducible, plan.frames, plan.fps, plan.stepsPerFrame));
    for (const int step : plan.slowSteps) hash.add(std::to_string(step));
    for (const std::string& name : options.show) hash.add(name);
    for (const Pass pass : plan.passes) hash.add(textOf(pass).name);
    for (const Panel& panel : plan.panels) {
        hash.add(std::to_string(panel.scene.contents));
        for (const std::string& name : panel.scene.look.show) hash.add(name);
        hash.add(panel.settings);
        hash.add(panel.overlays.theme);
        hash.add(panel.overlays.colorBy);
        hash.add(panel.overlays.text ? "text" : "clean");
    }
    hash.add(fmt::format("{} {} {}", static_cast<int>(plan.picture.finish), plan.shutter.moments,
                         plan.shutter.open));
    hash.add(plan.strip.pixels);
    return hash.value();
}

}  // namespace demos
