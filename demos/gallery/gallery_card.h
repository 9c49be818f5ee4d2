/// What a gallery says of one scene, and how it is sent between processes.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "demos/film/film_plan.h"
#include "demos/gallery/gallery_options.h"
#include "demos/gallery/gallery_scenes.h"

namespace demos {

struct GalleryCard {
    std::string name, group, title, purpose;
    std::string file;  // of a scene that is not built in, without its folder; else empty
    double seconds = 0.0;
    double posterTime = 0.0;  // s
    int bodies = 0, joints = 0, hz = 0;
    int frames = 0, fps = 0, width = 0, height = 0;
    std::uint64_t fingerprint = 0;  // of all that decides about the pictures
    bool film = false;              // there is one, besides the poster
};

/// `plan`: of the scene's film; `renderer`: as OpenGL names it.
GalleryCard cardOf(const GalleryChoice& choice, const FilmPlan& plan, const GalleryOptions& options,
                   const std::string& renderer);

nlohmann::ordered_json jsonOf(const GalleryCard& card);
/// Throws nlohmann's exceptions for what jsonOf did not make.
GalleryCard cardFrom(const nlohmann::ordered_json& json);

/// The options of one scene's film: 640x360 at 30 frames a second where nothing else was asked for,
/// or the next lower rate that the scene's steps allow.
GalleryOptions optionsOfFilm(const GalleryChoice& choice, const GalleryOptions& options);

}  // namespace demos
