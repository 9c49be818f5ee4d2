/// The cost of a film as an .mp4: the processor time of all its processes together.
#pragma once
#include <filesystem>

#include "demos/film/film_plan.h"

namespace demos {

/// ms of processor time a frame, over the whole film with its start, and where they go.
struct Mp4Timing {
    double workers = 0.0;  // simulate, draw, send the picture to the program
    double program = 0.0;  // receive the pictures, convert them, send them to the encoder
    double encoder = 0.0;  // ffmpeg
    double framesASecond = 0.0;  // wall-clock time
    double bytes = 0.0;          // of the file, per frame
    double all() const { return workers + program + encoder; }
};

/// Whether the film can be one: there is an ffmpeg, and an .mp4 takes its size, rate and theme.
bool canBeMp4(const FilmPlan& plan);

/// Makes the film `file` by `workers` processes. Throws Stop (interrupted; diverged if a step
/// fails) and render::Error. Counts all children that end meanwhile.
Mp4Timing timeMp4(const FilmPlan& plan, int workers, const std::filesystem::path& file);

}  // namespace demos
