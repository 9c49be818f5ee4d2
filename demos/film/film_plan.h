/// What a film will be, decided before anything is drawn.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/film/data_pass.h"
#include "demos/film/panel_layout.h"
#include "demos/film/shutter.h"
#include "demos/film/state_files.h"
#include "demos/look/overlays.h"
#include "demos/options/options.h"
#include "demos/scene/description.h"
#include "render/renderer.h"

namespace demos {

/// One picture of a film: the scene, or one of its variants.
struct Panel {
    SceneDescription scene;
    Overlays overlays;
    std::string settings;  // its difference from the other panels, as for --set
};

inline constexpr int kMostFrames = 1'000'000;

struct FilmPlan {
    std::vector<Panel> panels;  // one: an ordinary film
    PanelLayout layout;
    render::Image strip;  // a plot; empty = none
    struct {
        float start = 0, end = 0;  // pixels across, at time 0 and at the end
        float top = 0, bottom = 0;
    } cursor;                          // a line in the strip that marks the time
    render::RendererSettings picture;  // of one panel
    ShutterSettings shutter;
    std::string name;  // {scene} in output patterns
    std::string quality;
    std::vector<Pass> passes;  // beside PNG frames; one panel only
    std::string states;        // a folder with states to start from; empty: none
    std::string resume;        // the folder for states of an unfinished run; empty: none (resume_states.h)
    StateKind stateKind;       // of its states that fit
    int frames = 0;
    int fps = 30;
    int stepsPerFrame = 2;
    std::vector<int> slowSteps;  // of each frame, and the last, in a film with slow motion; else empty

    const SceneDescription& scene() const { return panels.front().scene; }
    /// Whether the pictures have a transparent background.
    bool alpha() const;
    /// Of the film, in s.
    double seconds() const { return static_cast<double>(frames) / fps; }
    /// The step of the run that a frame shows.
    int stepOf(int frame) const;
    /// Of the run, in s.
    double timeOf(int frame) const;
    /// The time of the film, in s, at which the run is at `time`, s.
    double filmTimeAt(double time) const;
    /// The first frame that shows the run at `time` (s) or later; may be after the film's last.
    int firstFrameAt(double time) const;
    /// The frame that is nearest to `time` (s) of the run.
    int frameAt(double time) const;
    /// The steps between that frame and the one before it.
    int stepsTo(double time) const;
};

/// The frame rates that divide a scene's steps a second, the six nearest to `wanted`: "20 30 60".
std::string goodRates(int hz, int wanted);

/// The steps a second nearest to `hz` that a frame rate divides, for `world.hz`.
int goodSteps(int hz, int fps);

/// The step nearest to `time` (s). Throws Stop (usage), which names `option`, if it is too far away
/// to simulate.
int stepAt(double time, const FilmPlan& plan, const char* option);

/// The scene with --set and --seconds applied; its notes are reported, unless quiet. Throws
/// SceneError.
SceneDescription sceneOf(const Options& options);

/// What a scene's pictures show: its own overlays and those of the options.
Overlays overlaysOf(const SceneDescription& scene, const Options& options);

/// Throws Stop (usage) if the frame rate does not divide the scene's steps a second, the film would
/// be too long, or the picture too small for its parts. With the slow motion of the scene's sections,
/// unless `options.anyStep`.
FilmPlan planFilm(const Options& options);

/// The same for several panels on one clock: their scenes have the same length, and each has its
/// own steps per frame. Fills in their overlays. `strip`: leaves room for a plot. No slow motion.
FilmPlan planFilm(std::vector<Panel> panels, bool strip, const Options& options);

/// Sets the camera of scenes without one, before anything is drawn. Costs a run of each such scene;
/// so all checks come first.
void fitCameras(FilmPlan& plan);

/// planFilm, with its cameras.
FilmPlan planPictures(const Options& options);

/// A hash of all that determines a picture's bits except the renderer: scene, program, settings.
std::uint64_t fingerprintOf(const FilmPlan& plan, const Options& options);

}  // namespace demos
