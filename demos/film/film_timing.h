/// The cost of a film: processor time of each stage of a frame, frames a second of all workers.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "demos/film/film_plan.h"
#include "demos/film/mp4_timing.h"

namespace demos {

constexpr std::array<const char*, 10> kFilmStages = {
    "simulate", "depth", "occlusion", "shadow", "scene",
    "read",     "resolve",  "overlay",   "encode", "write"};

/// Measured in a process of its own, which sends the bytes.
struct StageTimes {
    std::array<double, kFilmStages.size()> ms{};  // processor time per frame, median; for PNG files
    double start = 0.0;     // s, processor time of a drawing process before its first frame
    double pngBytes = 0.0;                        // per frame, median
    double drawn = 0.0;     // 0..1 of a picture, not kept from the last; mean without the first
    int frames = 0;
};

struct FilmTiming : StageTimes {
    int workers = 0;
    double framesASecond = 0.0;  // of the whole film as PNG files, wall-clock time
    std::optional<Mp4Timing> mp4;  // none: canBeMp4
    std::string incident;        // Player::incident; empty: none

    /// ms of drawing a frame: from the depths to the picture in memory.
    double drawing() const;
    /// 0.88 workers / (seconds of drawing a frame): the rate that the workers should reach.
    double goal() const;
};

/// Only the stages' times, of the first `frames` frames, or of at least five of them if they take
/// more than `seconds` of processor time. Throws as timeFilm().
FilmTiming timeFrames(const FilmPlan& plan, int frames, double seconds);

/// Makes the film three times, in a temporary folder that is removed: by `jobs` workers (0: one per
/// core) as PNG files and as an .mp4, then in a process of its own with a clock. Throws Stop (interrupted;
/// diverged if a step fails) and render::Error.
FilmTiming timeFilm(const FilmPlan& plan, int jobs);

}  // namespace demos
