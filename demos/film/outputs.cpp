#include "demos/film/outputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/film_plan.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/encode/video.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

std::string endingOf(const std::string& pattern) {
    std::string ending = fs::path(pattern).extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

Output framesOutput(const FilmPlan& plan, const std::string& pattern) {
    Output output;
    output.pattern = pattern;
    if (plan.frames > 1 && !namesEveryFrame(pattern))
        refuseOutput(pattern,
                     "every frame needs a name of its own, as in frame_####.png; for one "
                     "picture use 'impulse still'");
    output.path = fs::path(expandPattern(pattern, valuesOf(plan, 0))).parent_path();
    if (plan.frames > 1 &&
        fs::path(expandPattern(pattern, valuesOf(plan, 1))).parent_path() != output.path)
        refuseOutput(pattern,
                     "all frames go to one folder; only the name may have the frame's number");
    if (output.path.empty()) output.path = ".";
    return output;
}

Output outputOf(const FilmPlan& plan, const std::string& pattern) {
    if (pattern.empty())
        refuseOutput(pattern, "a file or folder is needed; '-' is standard output");
    if (pattern.find('\0') != std::string::npos) refuseOutput(pattern, "a name cannot contain NUL");
    Output output;
    if (pattern == "-") {
        output.kind = OutputKind::raw;
        return output;
    }
    const std::string ending = endingOf(pattern);
    if (ending == ".png") return framesOutput(plan, pattern);
    if (render::isVideoName(pattern)) {
        if (namesEveryFrame(pattern))
            refuseOutput(pattern, "a film is one file; leave the frame's number out");
        output.kind = OutputKind::film;
        output.path = expandPattern(pattern, valuesOf(plan, 0));
        return output;
    }
    const bool folder = ending.empty() || pattern.ends_with('/') || fs::is_directory(pattern);
    if (!folder)
        refuseOutput(pattern,
                     fmt::format("the file extension '{}' is not supported; known are: .png .mp4 .webm "
                                 ".gif .webp .apng, none for a folder",
                                 printable(ending)));
    return framesOutput(plan, (fs::path(pattern) / "frame_{frame:6}.png").string());
}

/// A part of a film is a file in a folder of its own.
void takePart(const Shard& shard, const std::string& pattern, Output& output) {
    const std::string ending = endingOf(pattern);
    const bool joins = ending == ".mp4" || ending == ".webm";
    if (output.kind == OutputKind::raw || (output.kind == OutputKind::film && !joins))
        refuseOutput(pattern, "with --shard a film must be .mp4, .webm or a folder of PNG frames, of which "
                              "impulse join makes any film");
    if (output.kind != OutputKind::film) return;
    output.path = partsFolderOf(output.path) / (shard.name() + ending);
    output.part = true;
}

/// Data is written only next to PNG frames.
void checkPasses(const std::vector<Output>& outputs, const FilmPlan& plan) {
    if (plan.passes.empty()) return;
    for (const Output& output : outputs)
        if (output.kind == OutputKind::frames) return;
    throw Stop(Exit::usage,
               fmt::format("--pass {}: data is written next to PNG frames; add a folder for both, "
                           "for example -o output/{}",
                           fmt::join(passNamesOf(plan.passes), ","), printable(plan.name)));
}

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

}  // namespace

fs::path partsFolderOf(fs::path film) { return film.replace_extension(".parts"); }

bool has(const std::vector<Output>& outputs, OutputKind kind) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [kind](const Output& output) { return output.kind == kind; });
}

PatternValues valuesOf(const FilmPlan& plan, int frame) {
    return {frame, plan.timeOf(frame), plan.name, plan.quality};
}

std::vector<Output> outputsOf(const FilmPlan& plan, const FilmOptions& options) {
    std::vector<std::string> patterns = options.outputs;
    if (patterns.empty()) patterns = {"output/{scene}"};
    std::vector<Output> outputs;
    for (const std::string& pattern : patterns) {
        Output output = outputOf(plan, pattern);
        if (options.shard) takePart(*options.shard, pattern, output);
        for (const Output& other : outputs)
            if (other.kind == output.kind && other.path == output.path)
                refuseOutput(pattern, "another --output goes there already");
        if (output.kind == OutputKind::raw && options.json)
            refuseOutput(pattern, "--json writes to standard output already");
        outputs.push_back(output);
    }
    const auto isFilm = [](const Output& output) { return output.kind == OutputKind::film; };
    if (options.maxSize && std::none_of(outputs.begin(), outputs.end(), isFilm))
        throw Stop(Exit::usage, "--max-size needs a film; name one, as in -o film.gif");
    if (options.shard && (outputs.size() > 1 || options.maxSize || !options.poster.empty()))
        throw Stop(Exit::usage, "--shard: a part has one --output and neither --max-size nor "
                                "--poster, which are for the whole film: impulse join has them");
    checkPasses(outputs, plan);
    return outputs;
}

void checkFilm(const fs::path& path, const render::VideoSource& source) {
    const std::string name = printable(path.string()), ending = endingOf(path.string());
    if (!render::haveFfmpeg())
        throw render::Error(fmt::format("'{}' needs ffmpeg, which is not installed; PNG frames "
                                        "(-o a folder) do not",
                                        name));
    const render::VideoFormat& format = *render::videoFormatOf(path);
    const bool even = source.width % 2 == 0 && source.height % 2 == 0;
    if (!even && (ending == ".mp4" || ending == ".webm"))
        throw Stop(Exit::usage, fmt::format("--size {}x{}: a {} film needs even sides", source.width,
                                            source.height, ending));
    if (source.alpha && !format.holdsAlpha)
        throw Stop(Exit::usage, fmt::format("--output '{}': a {} holds no alpha, which the theme "
                                            "'transparent' needs; use .webm, .webp, .apng or .gif",
                                            name, ending));
    if (source.fps > format.largestFps)
        throw Stop(Exit::usage, fmt::format("--fps {}: a {} film takes at most {} frames a second",
                                            source.fps, ending, format.largestFps));
}

void checkPlace(const fs::path& film, bool overwrite) {
    if (render::sweepTemporaries(film))
        throw Stop(Exit::wouldOverwrite,
                   fmt::format("'{}' is being written by another run; wait for it, or give "
                               "another name",
                               printable(film.string())));
    render::checkReplaceable(film);
    if (isThere(film) && !overwrite)
        throw Stop(Exit::wouldOverwrite, fmt::format("'{}' already exists; --overwrite replaces it",
                                                     printable(film.string())));
}

void checkOutputs(const std::vector<Output>& outputs, const FilmPlan& plan, bool overwrite) {
    for (const Output& output : outputs) {
        if (output.kind != OutputKind::film) continue;
        checkFilm(output.path, {plan.layout.width, plan.layout.height, plan.fps, plan.alpha()});
        if (!output.part) checkPlace(output.path, overwrite);
    }
}

void refuseToReplace(const fs::path& path, const std::string& what) {
    throw Stop(Exit::wouldOverwrite, fmt::format("'{}' {}", printable(path.string()), what));
}

}  // namespace demos
