/// Draws the two files of a scene in a gallery.
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

/// Draws a scene's poster and, if `film` is a name, its film, in this process. Leaves no incomplete
/// files. Throws likewise.
GalleryEntry drawScene(const FilmPlan& plan, const std::filesystem::path& poster,
                       const std::filesystem::path& film);

}  // namespace demos
