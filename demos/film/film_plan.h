/// What a film will be, settled before anything is drawn.
#pragma once
#include <cstdint>
#include <string>

#include "demos/film/data_pass.h"
#include "demos/film/panel_layout.h"
#include "demos/film/shutter.h"
#include "demos/look/overlays.h"
#include "demos/options/options.h"
#include "demos/scene/description.h"
#include "render/renderer.h"

namespace demos {

/// One of a film's pictures: the scene, or one of its variants.
struct Panel {
    SceneDescription scene;
    Overlays overlays;
    std::string settings;  // what makes it differ from the others, as --set would take it
};

inline constexpr int kMostFrames = 1'000'000;

struct FilmPlan {
    std::vector<Panel> panels;  // one: an ordinary film
    PanelLayout layout;
    render::Image strip;  // a plot; empty = none
    struct {
        float start = 0, end = 0;  // pixels across, at time 0 and at the end
        float top = 0, bottom = 0;
    } cursor;                          // a line in the strip that goes with the time
    render::RendererSettings picture;  // of one panel
    ShutterSettings shutter;
    std::string name;  // {scene} in output patterns
    std::string quality;
    std::vector<Pass> passes;  // beside PNG frames; one panel only
    int frames = 0;
    int fps = 30;
    int stepsPerFrame = 2;

    const SceneDescription& scene() const { return panels.front().scene; }
    /// Whether the pictures show what is behind them.
    bool alpha() const;
    double timeOf(int frame) const { return static_cast<double>(frame) / fps; }  // s
};

/// The frame rates that divide a scene's steps a second, the six nearest to `wanted`: "20 30 60".
std::string goodRates(int hz, int wanted);

/// The step nearest to `time` (s). Throws Stop (usage), in the name of `option`, where it is too
/// far to be played to.
int stepAt(double time, const FilmPlan& plan, const char* option);

/// The scene with --set and --seconds applied; its notes are reported, unless quiet. Throws
/// SceneError.
SceneDescription sceneOf(const Options& options);

/// Throws Stop (usage) where the frame rate does not divide the scene's steps a second, or the film
/// would be too long or the picture too large for this machine.
FilmPlan planFilm(const Options& options);

/// The same of several panels, which have one clock: their scenes have the same length and step.
/// `strip`: leaves room for a plot. Their overlays are filled in.
FilmPlan planFilm(std::vector<Panel> panels, bool strip, const Options& options);

/// Everything that decides about a picture's bits, but the renderer: scene, program, settings.
std::uint64_t fingerprintOf(const FilmPlan& plan, const Options& options);

}  // namespace demos
