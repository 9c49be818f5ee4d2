#include <fmt/format.h>

#include <memory>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/outputs.h"
#include "demos/film/parts.h"
#include "demos/film/progress.h"
#include "demos/text/complaints.h"
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

void joinFilm(const Parts& parts, const JoinOptions& options, const Talk& talk) {
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

/// The frames are in place already; only the record of the whole film is missing.
void joinFrames(const Parts& parts, const JoinOptions& options, const Talk& talk) {
    if (!options.outputs.empty())
        refuse("--output: parts of PNG frames stay where they are; leave it out");
    RunRecord whole = parts.whole;
    whole.shard.clear();
    whole.finished = true;
    const fs::path file = fs::path(options.folder) / "run.json";
    render::writeFileAtomically(file, jsonOf(whole));
    const std::size_t frames = whole.frames.size();
    talk.say(fmt::format("wrote {} ({} of {})", printable(file.string()), plural(frames, "frame"),
                         plural(parts.count, "part")));
    talk.json(fmt::format(R"({{"event":"done","file":{},"frames":{}}})", jsonString(file.string()),
                          frames));
}

Exit join(const JoinOptions& options) {
    std::error_code ignored;
    if (!fs::is_directory(options.folder, ignored))
        refuse(fmt::format("'{}' is not a folder of parts; impulse render --shard makes one",
                           printable(options.folder)));
    const Talk talk(options, false);
    const Parts parts = partsIn(options.folder);
    if (!parts.wanted.empty()) refuseIncomplete(parts, options, talk);
    if (parts.films) joinFilm(parts, options, talk);
    else joinFrames(parts, options, talk);
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
                   "the film, of the same type as the parts; default: FOLDER without .parts")
        ->type_name("FILE")
        ->expected(1);
    app.add_flag("--overwrite", options.overwrite, "replace what is there; default: off");
    addFeedback(app, options);
    return [asked](const std::string& commandLine) { return join(settled(*asked, commandLine)); };
}

}  // namespace

Command joinCommand() {
    return {"join",
            "join the parts of a film that were drawn with --shard",
            {"impulse join wall.parts", "impulse join wall.parts -o films/wall.mp4",
             "impulse join output/wall"},
            addJoin};
}

}  // namespace demos
