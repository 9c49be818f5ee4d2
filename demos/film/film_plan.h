/// What a film will be, settled before anything is drawn.
#pragma once
#include <cstdint>
#include <string>

#include "demos/options.h"
#include "demos/overlays.h"
#include "demos/scene/description.h"
#include "render/renderer.h"

namespace demos {

struct FilmPlan {
    SceneDescription scene;
    Overlays overlays;
    render::RendererSettings picture;
    std::string quality;
    int frames = 0;
    int fps = 30;
    int stepsPerFrame = 2;

    double timeOf(int frame) const { return static_cast<double>(frame) / fps; }  // s
};

/// The scene with --set and --seconds applied. Throws SceneError.
SceneDescription sceneOf(const Options& options);

/// Throws Stop (usage) where the frame rate does not divide the scene's steps a second, or the film
/// would be too long or the picture too large for this machine.
FilmPlan planFilm(const Options& options);

/// Everything that decides about a picture's bits, but the renderer: scene, program, settings.
std::uint64_t fingerprintOf(const FilmPlan& plan, const Options& options);

}  // namespace demos
