#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "demos/commands/commands.h"
#include "demos/commands/option_checks.h"
#include "demos/commands/shared_options.h"
#include "demos/film/film_of_frames.h"
#include "demos/film/outputs.h"
#include "demos/film/parts.h"
#include "demos/film/progress.h"
#include "demos/film/run_record.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/plural.h"
#include "demos/text/table.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/join_films.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

struct JoinOptions : Options {
    std::string folder;
    std::string maxSize, poster;  // of a film of PNG frames
    std::string captions;
};

/// Prints the commands that draw the missing parts, then ends the run.
[[noreturn]] void refuseIncomplete(const Parts& parts, const JoinOptions& options,
                                   const Talk& talk) {
    for (const int number : parts.wanted) {
        const std::string command = commandOf(parts, number);
        if (!command.empty()) talk.say("to do: " + printable(command));
        talk.json(fmt::format(R"({{"event":"wanted","shard":{},"command":{}}})", number,
                              jsonString(command)));
    }
    throw Stop(Exit::incomplete,
               fmt::format("'{}': {} of {} parts are complete; {}", printable(options.folder),
                           parts.count - static_cast<int>(parts.wanted.size()), parts.count,
                           fmt::join(parts.troubles, "; ")));
}

/// --output, or the folder's name with the parts' extension instead of .parts.
std::string targetOf(const Parts& parts, const JoinOptions& options) {
    const std::string ending = parts.files.front().extension().string();
    if (options.outputs.empty())
        return fs::path(options.folder).lexically_normal().replace_extension(ending).string();
    const std::string& target = options.outputs.front();
    if (fs::path(target).extension() != ending)
        refuse(fmt::format("--output '{}': must end in {}, as the parts do",
                           printable(target), ending));
    return target;
}

void checkCaptions(const RunRecord& whole, const JoinOptions& options) {
    if (options.captions.empty()) return;
    const std::string name = printable(options.captions);
    if (!options.captions.ends_with(".vtt")) refuse(fmt::format("--captions '{}': captions end in .vtt", name));
    if (whole.captions.empty())
        refuse(fmt::format("--captions '{}': no [[section]] of the scene has a caption", name));
    checkFree(options.captions, options.overwrite);
}

void writeCaptions(const RunRecord& whole, const JoinOptions& options, const Talk& talk) {
    if (options.captions.empty()) return;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(whole.captions.data());
    writeResult(options.captions, {bytes, whole.captions.size()}, existingFiles(options.overwrite));
    talk.say("wrote " + printable(options.captions));
}

void joinFilm(const Parts& parts, const JoinOptions& options, const Talk& talk) {
    if (!options.maxSize.empty() || !options.poster.empty())
        refuse("--max-size and --poster need parts of PNG frames (impulse render -o a folder --shard)");
    const std::string target = targetOf(parts, options);
    const int frames = static_cast<int>(parts.whole.frames.size());
    if (!render::haveFfmpeg())
        throw render::Error("joining films needs ffmpeg, which is not installed");
    checkFree(target, options.overwrite);
    render::makeFolder(fs::path(target).parent_path());
    render::joinFilms(parts.files, frames, target, existingFiles(options.overwrite),
                      parts.whole.chapters, parts.whole.fps);
    talk.say(fmt::format("wrote {} ({} of {})", printable(target), plural(frames, "frame"),
                         plural(parts.count, "part")));
    talk.json(
        fmt::format(R"({{"event":"done","file":{},"frames":{}}})", jsonString(target), frames));
}

/// Makes a film of the frames.
void joinToFilm(const FramesToFilm& job, std::uint64_t largest, const JoinOptions& options, const Talk& talk) {
    const render::Fit fit{largest, interrupted, [&talk](const std::string& line) { talk.mention(line); }};
    watchSignals();
    const int frames = static_cast<int>(job.record.frames.size());
    Progress progress(options, frames, 0);
    const std::string size = encodeFrames(job, fit, [&] { progress.advance(); });
    progress.finish();
    talk.say(fmt::format("wrote {} ({})", printable(job.film.string()), size.empty() ? plural(frames, "frame") : size));
}

void checkPoster(const JoinOptions& options) {
    if (options.poster.empty()) return;
    if (!options.poster.ends_with(".png"))
        refuse(fmt::format("--poster '{}': a poster ends in .png", printable(options.poster)));
    checkFree(options.poster, options.overwrite);
}

/// The frame's number may come from another machine's record.
void copyPoster(const RunRecord& whole, const JoinOptions& options, const Talk& talk) {
    const std::vector<std::uint8_t> png = contentOf(frameFile(whole, options.folder, whole.poster));
    if (png.empty())
        throw render::Error(fmt::format("'{}': the poster is frame {}, which is not there",
                                        printable(options.folder), whole.poster));
    writeResult(options.poster, png, existingFiles(options.overwrite));
    talk.say(fmt::format("wrote {} (frame {})", printable(options.poster), whole.poster));
}

/// The frames are in place already; only the record of the whole film is missing, and what needs all frames.
void joinFrames(const Parts& parts, const JoinOptions& options, const Talk& talk) {
    RunRecord whole = parts.whole;
    whole.shard.clear();
    whole.finished = true;
    const FramesToFilm job{whole, options.folder, options.outputs.empty() ? "" : options.outputs.front(),
                           existingFiles(options.overwrite)};
    if (!job.film.empty()) checkFramesToFilm(job);
    else if (!options.maxSize.empty()) refuse("--max-size needs a film; name one, as in -o film.gif");
    const std::uint64_t largest = options.maxSize.empty() ? 0 : maxSizeFrom(options.maxSize);
    checkPoster(options);
    const fs::path file = fs::path(options.folder) / "run.json";
    render::writeFileAtomically(file, jsonOf(whole));
    const std::size_t frames = whole.frames.size();
    talk.say(fmt::format("wrote {} ({} of {})", printable(file.string()), plural(frames, "frame"),
                         plural(parts.count, "part")));
    if (!job.film.empty()) joinToFilm(job, largest, options, talk);
    if (!options.poster.empty()) copyPoster(whole, options, talk);
    talk.json(fmt::format(R"({{"event":"done","file":{},"frames":{}}})",
                          jsonString(job.film.empty() ? file.string() : job.film.string()), frames));
}

Exit join(const JoinOptions& options) {
    std::error_code ignored;
    if (!fs::is_directory(options.folder, ignored))
        refuse(fmt::format("'{}' is not a folder of parts; impulse render --shard makes one",
                           printable(options.folder)));
    const Talk talk(options, false);
    const Parts parts = partsIn(options.folder);
    if (!parts.wanted.empty()) refuseIncomplete(parts, options, talk);
    checkCaptions(parts.whole, options);
    if (parts.films) joinFilm(parts, options, talk);
    else joinFrames(parts, options, talk);
    writeCaptions(parts.whole, options, talk);
    if (!parts.whole.incident.empty()) throw Stop(Exit::diverged, parts.whole.incident);
    return Exit::ok;
}

Run addJoin(CLI::App& app) {
    const auto asked = std::make_shared<Asked<JoinOptions>>();
    auto& options = asked->options;
    app.add_option("folder", options.folder, "the folder that impulse render --shard wrote to")
        ->type_name("FOLDER")
        ->required();
    app.add_option("-o,--output", options.outputs,
                   "the film: of parts of a film, of their type; of PNG frames any, .mp4 .webm .gif .webp "
                   ".apng; default: FOLDER without .parts, none of PNG frames")
        ->type_name("FILE")
        ->expected(1);
    app.add_option("--max-size", options.maxSize,
                   "of PNG frames: largest film in bytes, as for impulse render; default: no limit")
        ->type_name("BYTES");
    app.add_option("--poster", options.poster,
                   "of PNG frames: write the scene's section.poster, else the middle frame, as a .png; "
                   "default: not written")
        ->type_name("FILE");
    app.add_option("--captions", options.captions,
                   "write the sections' captions as a .vtt, as impulse render does; default: not written")
        ->type_name("FILE");
    app.add_flag("--overwrite", options.overwrite, "replace what is there; default: off");
    addFeedback(app, options);
    return [asked](const std::string& commandLine) { return join(settled(*asked, commandLine)); };
}

}  // namespace

Command joinCommand() {
    return {"join",
            "join the parts of a film that were drawn with --shard",
            {"impulse join wall.parts", "impulse join wall.parts -o films/wall.mp4",
             "impulse join output/wall -o wall.gif --max-size 8M --poster wall.png"},
            addJoin};
}

}  // namespace demos
