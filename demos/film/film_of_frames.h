/// A film of PNG frames that parts of a run have drawn: what needs all frames at once (the palette of a GIF, a
/// size limit, a poster) is made when all are there.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "demos/film/run_record.h"
#include "render/encode/file.h"
#include "render/encode/fit.h"

namespace demos {

struct FramesToFilm {
    const RunRecord& record;        // of the whole run
    std::filesystem::path folder;   // of the frames
    std::filesystem::path film;     // the file to write
    render::Existing existing = render::Existing::kept;
};

/// The same film as `impulse render -o FILM` writes. `advance` is called after every frame. Returns what the size
/// limit has cost; empty: there is none. Throws render::Error, Stop (interrupted).
std::string encodeFrames(const FramesToFilm& job, const render::Fit& fit, const std::function<void()>& advance);

/// Throws Stop (usage, wouldOverwrite) or render::Error if the film cannot be written.
void checkFramesToFilm(const FramesToFilm& job);

}  // namespace demos
