/// Where a film goes: -o, understood.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/film/film_options.h"
#include "demos/film/film_plan.h"
#include "demos/film/pattern.h"

namespace demos {

enum class OutputKind {
    frames,  // PNG files and their run.json
    film,    // a video
    raw      // RGBA, a frame after the other, on standard output
};

struct Output {
    OutputKind kind = OutputKind::frames;
    std::string pattern;         // frames: of the files' names
    std::filesystem::path path;  // film: the file; frames: their folder
    bool part = false;           // of a film: made anew unless it is there
};

/// film.mp4: film.parts, where a --shard goes.
std::filesystem::path partsFolderOf(std::filesystem::path film);

bool has(const std::vector<Output>& outputs, OutputKind kind);

/// Throws Stop (usage) for what cannot be written, or twice to one place.
std::vector<Output> outputsOf(const FilmPlan& plan, const FilmOptions& options);

/// Throws Stop (wouldOverwrite) or render::Error where that can be known before drawing.
void checkOutputs(const std::vector<Output>& outputs, const FilmPlan& plan, bool overwrite);

/// Throws Stop (wouldOverwrite); `what`: the path is.
[[noreturn]] void refuseToReplace(const std::filesystem::path& path, const std::string& what);

PatternValues valuesOf(const FilmPlan& plan, int frame);

}  // namespace demos
