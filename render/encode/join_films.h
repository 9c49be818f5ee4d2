/// Joins films without encoding them again.
#pragma once
#include <filesystem>
#include <span>

#include "render/encode/chapters.h"
#include "render/encode/file.h"

namespace render {

/// `parts`: of one kind (.mp4 or .webm, as `target`), size, rate and encoding. `frames`: the total
/// number. `chapters`: of the whole film, at `fps` frames per second. The target is written
/// completely or not at all. Throws Error, AlreadyThere.
void joinFilms(std::span<const std::filesystem::path> parts, int frames,
               const std::filesystem::path& target, Existing existing,
               std::span<const Chapter> chapters = {}, int fps = 30);

}  // namespace render
