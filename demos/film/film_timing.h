/// What a film costs: processor time of each stage of a frame, and frames a second by all workers.
#pragma once
#include <array>
#include <string>

#include "demos/film/film_plan.h"

namespace demos {

constexpr std::array<const char*, 10> kFilmStages = {
    "simulate", "depth", "occlusion", "shadow", "scene",
    "read",     "resolve",  "overlay",   "encode", "write"};

struct FilmTiming {
    std::array<double, kFilmStages.size()> ms{};  // processor time a frame, median; PNG files
    double pngBytes = 0.0;                        // a frame, median
    int frames = 0;
    int workers = 0;
    double framesASecond = 0.0;  // of the whole film to PNG files, by the clock on the wall

    /// What is drawn: from the depths to the picture in memory.
    double drawing() const;
    /// 0.88 workers / (seconds of drawing a frame): what the workers should at least reach.
    double goal() const;
};

/// Makes the film twice, in a temporary folder that is removed: by `jobs` workers (0: one a core),
/// then in this process with a clock. Throws Stop (diverged, interrupted) and render::Error.
FilmTiming timeFilm(const FilmPlan& plan, int jobs);

}  // namespace demos
