/// Where a film is written: -o, parsed.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/film/film_options.h"
#include "demos/film/pattern.h"
#include "render/encode/video_format.h"

namespace demos {

struct FilmPlan;

enum class OutputKind {
    frames,  // PNG files and their run.json
    film,    // a video
    raw      // RGBA, one frame after the other, on standard output
};

struct Output {
    OutputKind kind = OutputKind::frames;
    std::string pattern;         // frames: for the files' names
    std::filesystem::path path;  // film: the file; frames: their folder
    bool part = false;           // of a film: drawn again unless it is complete
};

/// film.mp4 -> film.parts: the folder of the parts that --shard makes.
std::filesystem::path partsFolderOf(std::filesystem::path film);

bool has(const std::vector<Output>& outputs, OutputKind kind);

/// Throws Stop (usage) for an output that cannot be written or is given twice.
std::vector<Output> outputsOf(const FilmPlan& plan, const FilmOptions& options);

/// Throws Stop or render::Error if no film of these pictures can be written to `path`.
void checkFilm(const std::filesystem::path& path, const render::VideoSource& source);

/// Throws Stop (wouldOverwrite) or render::Error if a film there is being written, or is not to be replaced.
void checkPlace(const std::filesystem::path& film, bool overwrite);

/// Throws Stop or render::Error for problems that can be known before drawing.
void checkOutputs(const std::vector<Output>& outputs, const FilmPlan& plan, bool overwrite);

/// Throws Stop (wouldOverwrite): "'PATH' WHAT".
[[noreturn]] void refuseToReplace(const std::filesystem::path& path, const std::string& what);

PatternValues valuesOf(const FilmPlan& plan, int frame);

}  // namespace demos
