/// Makes the files of a scene in a gallery.
#pragma once
#include <filesystem>

#include "demos/film/film_plan.h"
#include "demos/gallery/gallery_record.h"

namespace demos {

struct DrawnPoster {
    render::Image image;
    std::string incident;  // until then (Player::incident)
};

/// The frame that represents the scene, without its text. Throws Stop (diverged) if a step fails,
/// render::Error.
DrawnPoster drawPoster(const FilmPlan& plan);

/// The files of a scene; an empty name: not made.
struct GalleryFiles {
    std::filesystem::path poster, film, replay;
};

/// Makes a scene's files in this process. Leaves no incomplete ones. Throws likewise.
GalleryEntry drawScene(const FilmPlan& plan, const GalleryFiles& files);

}  // namespace demos
