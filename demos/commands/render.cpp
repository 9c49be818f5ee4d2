#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/commands/render_options.h"
#include "demos/film/film.h"
#include "demos/film/progress.h"
#include "demos/play/warnings.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

/// Options for publishing a film: the size limit of a page or a chat, a picture shown before it
/// plays.
void addDelivery(CLI::App& app, FilmOptions& options, OptionTexts& texts) {
    app.add_option("--max-size", texts.maxSize,
                   "largest film in bytes, e.g. 8M (K, M, G count in thousands); to fit, quality, "
                   "then frame rate, then picture size are reduced; default: no limit")
        ->type_name("BYTES");
    app.add_option("--poster", options.poster,
                   "write one frame as a .png, patterns as above; default: not written")
        ->type_name("FILE");
    app.add_option("--poster-time", options.posterTime,
                   "time of the poster in s; default: the scene's section.poster, else the middle "
                   "of the film")
        ->type_name("S");
    app.add_option("--captions", options.captions,
                   "write the sections' captions as a .vtt, which players show as subtitles or "
                   "chapters; patterns as above; default: not written")
        ->type_name("FILE");
}

Exit render(const FilmOptions& options) {
    FilmPlan plan = planFilm(options);
    plan.passes = passesCalled(options.passes);
    plan.states = options.states;
    if (!plan.states.empty()) plan.stateKind = stateKindOf(plan.scene(), options);
    for (const Panel& panel : plan.panels)
        for (const std::string& line : warningsAtStart(Stage(panel.scene)))
            Talk(options, true).mention("warning: " + printable(line));
    makeFilm(plan, options);
    return Exit::ok;
}

/// The frames that are drawn, by which of several runs.
void addFrames(CLI::App& app, FilmOptions& options, OptionTexts& texts) {
    CLI::Option* frames = app.add_option(
        "--frames", options.frames,
        "these frames only, with commas: 120..179, 0..-1 (to the last), 0..299:2, 20; default: "
        "all");
    frames->type_name("LIST");
    app.add_option("--shard", texts.shard,
                   "draw part K of N, for impulse join: PNG frames, or a film in NAME.parts/; what "
                   "exists is not drawn again; default: the whole film")
        ->type_name("K/N")
        ->excludes(frames);
    app.add_option("--states", options.states,
                   "a folder with states of 'impulse sim --states': the simulation starts from the "
                   "last one before the first frame, if one fits; default: from time 0")
        ->type_name("DIR");
}

Exit checkAndRender(FilmOptions& options, const OptionTexts& texts) {
    options.passes = texts.passes;
    for (const std::string& name : options.passes) checkName("--pass", name, passNames());
    if (!texts.shard.empty()) options.shard = shardCalled(texts.shard);
    if (!texts.maxSize.empty()) options.maxSize = maxSizeFrom(texts.maxSize);
    if (options.posterTime && options.poster.empty())
        refuse("--poster-time needs --poster; name a file for the poster");
    checkTime("--poster-time", options.posterTime);
    spareScenes(options.scenes, {options.poster, options.captions});
    return render(options);
}

Run addRender(CLI::App& app) {
    const auto asked = std::make_shared<Asked<FilmOptions>>();
    addRenderOptions(app, asked->options, asked->texts);
    return [asked](const std::string& commandLine) {
        return checkAndRender(settled(*asked, commandLine), asked->texts);
    };
}

}  // namespace

void addRenderOptions(CLI::App& app, FilmOptions& options, OptionTexts& texts) {
    addSceneChoice(app, options, texts);
    takesAgain(app.add_option(
                      "-o,--output", options.outputs,
                      "a folder, a pattern (#### %06d {frame:6} {scene} {quality} {time}), a film (.mp4 "
                      ".webm .gif .webp .apng) or - for raw RGBA; may be given again; "
                      "default: output/<scene>")
                   ->type_name("OUT"));
    addDelivery(app, options, texts);
    addSeconds(app, options);
    addPicture(app, options, texts);
    addWholeFrames(app, options);
    takesList(app.add_option(
                     "--pass", texts.passes,
                     "data next to the PNG frames, with commas: depth depth16 normal id flow "
                     "camera poses contacts events; described in passes.json; default: none")
                  ->type_name("NAMES"));
    addFrames(app, options, texts);
    addJobs(app, options);
    app.add_flag("-n,--dry-run", options.dryRun,
                 "print the frames, memory and disk space needed; draw nothing; default: off");
    addFeedback(app, options);
}

Command renderCommand() {
    return {"render",
            "simulate and write a film: PNG frames, or a video",
            {"impulse render stack", "impulse render stack -o stack.mp4 -q high",
             "impulse render my.toml -o 'frames/{scene}_####.png' --show contacts,impulses"},
            addRender};
}

}  // namespace demos
