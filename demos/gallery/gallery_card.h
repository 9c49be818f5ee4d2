/// What a gallery says of one scene, and its JSON between processes.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "demos/gallery/gallery_options.h"
#include "demos/gallery/gallery_scenes.h"

namespace demos {

struct FilmPlan;

struct GalleryCard {
    std::string name, group, title, purpose;
    std::string file;  // name of the scene file without its folder; empty: built in
    double seconds = 0.0;
    double posterTime = 0.0;  // s
    int bodies = 0, joints = 0, hz = 0;
    int frames = 0, fps = 0, width = 0, height = 0;
    std::uint64_t fingerprint = 0;  // of all that determines the pictures
    bool film = false;              // there is a film besides the poster
    bool replay = false;            // and a page to step through the run
};

/// `plan`: of the scene's film; `renderer`: as OpenGL names it.
GalleryCard cardOf(const GalleryChoice& choice, const FilmPlan& plan, const GalleryOptions& options,
                   const std::string& renderer);

nlohmann::ordered_json jsonOf(const GalleryCard& card);
/// Throws nlohmann's exceptions for JSON that jsonOf did not make.
GalleryCard cardFrom(const nlohmann::ordered_json& json);

/// The options of one scene's film: 640x360 at 30 frames a second unless others were given, or the
/// next lower rate that the scene's steps allow.
GalleryOptions optionsOfFilm(const GalleryChoice& choice, const GalleryOptions& options);

}  // namespace demos
