/// Draws the two files of a scene in a gallery.
#pragma once
#include <filesystem>

#include "demos/film/film_plan.h"
#include "demos/gallery/gallery_record.h"

namespace demos {

/// The frame that represents the scene, without its text. Throws Stop (diverged), render::Error.
render::Image drawPoster(const FilmPlan& plan);

/// Draws a scene's poster and, if `film` is a name, its film, in this process. Leaves no incomplete
/// files. Throws likewise.
GalleryEntry drawScene(const FilmPlan& plan, const std::filesystem::path& poster,
                       const std::filesystem::path& film);

}  // namespace demos
