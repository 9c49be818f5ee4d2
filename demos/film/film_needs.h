/// The memory and disk space that a film needs, estimated before anything is drawn.
#pragma once
#include <string>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/film/outputs.h"

namespace demos {

/// In bytes unless stated otherwise.
struct FilmNeeds {
    int workers = 1;      // drawing processes
    double worker = 0;    // memory of each
    double program = 0;   // the process that puts the frames in order and writes them
    double encoders = 0;  // ffmpeg, one for every video
    double disk = 0;      // an estimate: it depends on the pictures
    double memory() const { return workers * worker + program + encoders; }
};

FilmNeeds needsOf(const FilmPlan& plan, int workers, const std::vector<Output>& outputs);

/// Memory of this machine, or of the container that the program runs in; 0 = unknown.
double machineMemory();

/// Throws Stop (environment) if the film needs over 80 % of the memory, or a process more than the
/// limit of its address space; says what would fit.
void checkNeeds(const FilmNeeds& needs, const FilmPlan& plan);

/// What --dry-run prints: several lines, or one JSON object.
std::string needsText(const FilmNeeds& needs, const FilmPlan& plan,
                      const std::vector<Output>& outputs);
std::string needsJson(const FilmNeeds& needs, const FilmPlan& plan);

}  // namespace demos
