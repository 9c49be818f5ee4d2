/// The two files of a gallery's scene.
#pragma once
#include <filesystem>

#include "demos/film/film_plan.h"
#include "demos/gallery/gallery_record.h"

namespace demos {

/// The frame that stands for the scene, without its text. Throws Stop (diverged), render::Error.
render::Image drawPoster(const FilmPlan& plan);

/// Draws a scene's poster and, where `film` is a name, its film, in this process. What is not whole
/// is not there. Throws likewise.
GalleryEntry drawScene(const FilmPlan& plan, const std::filesystem::path& poster,
                       const std::filesystem::path& film);

}  // namespace demos
