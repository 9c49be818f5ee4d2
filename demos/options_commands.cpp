#include "demos/options_commands.h"

#include <string>

#include "demos/options_testing.h"
#include "demos/options_groups.h"

namespace demos {
namespace {

void addRender(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    takesAgain(app.add_option(
                      "-o,--output", options.outputs,
                      "a folder, a pattern (#### {frame:6} {scene} {quality} {time}), a film (.mp4 "
                      ".webm .gif .webp .apng) or - for raw RGBA; may be given again; "
                      "default: output/<scene>")
                   ->type_name("OUT"));
    addDelivery(app, options, raw);
    addSeconds(app, options);
    addPicture(app, options, raw);
    takesList(app.add_option(
                     "--pass", raw.passes,
                     "data beside the PNG frames, with commas: depth depth16 normal id flow camera "
                     "poses contacts events; described in passes.json; default: none")
                  ->type_name("NAMES"));
    addJobs(app, options);
    app.add_flag("-n,--dry-run", options.dryRun,
                 "say how many frames, memory and disk it takes; draw nothing; default: off");
    addFeedback(app, options);
}

void addStrip(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    CLI::Option* moments = app.add_option(
        "-n,--moments", options.moments,
        "how many, 1..100, evenly from the film's first frame to its last; default: 6");
    moments->type_name("N");
    app.add_option("--times", raw.times, "which, in s, with commas, rising; default: evenly")
        ->type_name("S,S")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(moments);
    app.add_option("--columns", options.columns,
                   "moments in a row; default: 0, up to six, and all rows alike")
        ->type_name("N");
    app.add_option("-o,--output", options.outputs,
                   "a .png, patterns as for render, or - ; default: output/<scene>/strip.png")
        ->type_name("OUT")
        ->expected(1);
    addSeconds(app, options);
    addPicture(app, options, raw);
    app.get_option("--size")->description(
        "pixels of one picture, 1..16384 a side; default: half of the quality's");
    app.get_option("--clean")->description("no times below the pictures; default: off");
    addFigure(app, options, raw);
    addFeedback(app, options);
}

void addStill(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    CLI::Option* time = app.add_option("-t,--time", options.time, "time in s; default: the end");
    time->type_name("S");
    app.add_option("-f,--frame", options.frame,
                   "number of the frame in the film; negative: from the end; default: the last")
        ->type_name("N")
        ->excludes(time);
    app.add_option(
           "-o,--output", options.outputs,
           "a .png, patterns as for render, or - ; default: output/<scene>/still_<time>.png")
        ->type_name("OUT")
        ->expected(1);
    addSeconds(app, options);
    addPicture(app, options, raw);
    addFigure(app, options, raw);
    addFeedback(app, options);
}

void addSim(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    addSeconds(app, options);
    const auto table = [&](const char* name, std::string& file, const char* columns) {
        app.add_option(name, file, std::string(columns) + "; default: not written")
            ->type_name("FILE|-");
    };
    table("--csv", options.csv, "a row a step: energies (J), contacts, penetration (m), residual");
    table("--bodies", options.bodies, "a row a step and body: position (m), rotation, velocities");
    table("--joints", options.joints, "a row a step and joint: separation (m), force, position");
    table("--contacts", options.contacts, "a row a contact point: where, normal, impulse (N s)");
    table("--sweeps", options.sweeps, "a row a sweep: residual (m/s), change (N s)");
    table("--events", options.events, "JSON: contacts that begin and end, joints that break");
    app.add_flag("--exact", options.exact,
                 "with --sweeps: the distance to the direct solution; slow; default: off");
    app.add_option("--every", options.every, "rows of every Nth step only; default: 1")
        ->type_name("N");
    app.add_option("--plot", options.plot,
                   "energy, penetration, joints and residual over time, as .svg or .png; "
                   "default: not drawn")
        ->type_name("FILE");
    app.add_flag("--hash", options.hash, "print the last step's state hash; default: off");
    app.add_option("--hash-every", options.hashEvery, "and every Nth step's; default: 0, off")
        ->type_name("N");
    app.add_flag("--expect,!--no-expect", options.expect,
                 "check the scene's [[expect]]; default: on");
    addFeedback(app, options);
}

void addPlot(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    takesAgain(app.add_option("-o,--output", options.outputs,
                              "a .svg or a .png; may be given again; default: output/<scene>.svg")
                   ->type_name("FILE"));
    takesList(
        app.add_option(
               "--what", raw.what,
               "charts, with commas: energy penetration separation contacts impulse residual; "
               "default: energy,penetration,separation,residual where there is something")
            ->type_name("NAMES"));
    app.add_option("--size", raw.size,
                   "pixels, 1..16384 a side; default: 1280 wide, 360 high a chart, 720 at least")
        ->type_name("WxH");
    app.add_option("--theme", options.theme,
                   "studio, dark, print or transparent; default: the scene's")
        ->type_name("NAME");
    addFigure(app, options, raw);
    app.add_flag("--overwrite", options.overwrite,
                 "replace a figure and its caption; a plot without a caption is always replaced; "
                 "default: off");
    addSeconds(app, options);
    addFeedback(app, options);
}

void addExport(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    takesAgain(
        app.add_option(
               "-o,--output", options.outputs,
               ".glb: bodies, colours and camera with their motion; .csv: poses, a row a frame "
               "and body, columns of 'sim --bodies'; .npz: the same, energies and contacts as "
               "arrays for numpy; .json: the events of 'sim --events'; .html: a page to look at "
               "the "
               "run from all sides, without a network; may be given again; "
               "default: output/<scene>.glb")
            ->type_name("FILE"));
    app.add_option("--fps", options.fps,
                   "frames a second; the scene's steps a second must be a multiple; default: 30")
        ->type_name("N");
    addSeconds(app, options);
    app.add_flag("--overwrite", options.overwrite, "replace what is there; default: off");
    addFeedback(app, options);
}

void addSlides(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    app.get_option("scene")
        ->expected(1, kMostScenes)
        ->description("a deck file, or scenes whose sections become slides");
    takesAgain(
        app.add_option(
               "-o,--output", options.outputs,
               ".html: one page with everything in it; .pdf: a picture a slide, by Chromium; a "
               "folder: page, films, pictures, notes, for LaTeX (Beamer) and Marp; may be given "
               "again; default: output/<name>.html")
            ->type_name("OUT"));
    addSeconds(app, options);
    app.add_option("--size", raw.size,
                   "pixels of a picture that fills a slide, even, 64..8192 a side; default: the deck's, "
                   "1280x720")
        ->type_name("WxH");
    app.add_option("--fps", options.fps, "frames a second of films; default: the deck's, 30")
        ->type_name("N");
    app.add_option("--samples", options.samples,
                   "samples of a pixel with an edge: 1, 2, 4, 8 or 16; default: 4")
        ->type_name("N");
    app.add_option("--theme", options.theme, "studio, dark or print; default: the deck's, studio")
        ->type_name("NAME");
    addJobs(app, options);
    app.add_flag("-n,--dry-run", options.dryRun,
                 "say what the deck holds and where it goes; draw nothing; default: off");
    addRenderer(app, options);
    app.add_flag("--overwrite", options.overwrite,
                 "replace what is there; in a folder, what slides has made; default: off");
    addFeedback(app, options);
}

/// Several runs of one scene, as a table, as a film and as a figure.
void addRuns(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    addSeconds(app, options);
    addPicture(app, options, raw);
    addFigure(app, options, raw);
    app.add_option("-t,--time", options.time, "with --width: of the figure, in s; default: the end")
        ->type_name("S");
    addJobs(app, options);
    app.add_option("--measure", options.measure,
                   "what to plot: drift speed penetration separation energy residual "
                   "sweeps ms; "
                   "default: the most telling")
        ->type_name("NAME");
    addFeedback(app, options);
}

void addCompare(CLI::App& app, Options& options, RawOptions& raw) {
    addRuns(app, options, raw);
    app.get_option("scene")->expected(0, 1)->required(false);
    takesAgain(app.add_option(
                      "--vary", options.vary,
                      "a setting and its values, e.g. solver.nudges=0,4; several: all combinations")
                   ->type_name("KEY=A,B"));
    takesAgain(
        app.add_option(
               "--case", options.cases,
               "settings that go together: 'LABEL: KEY=VALUE KEY=VALUE'; two to four of them")
            ->type_name("CASE"));
    app.add_option("--plot", options.plot,
                   "the measure over time alone, as .svg or .png; default: not drawn")
        ->type_name("FILE");
    takesAgain(
        app.add_option("-o,--output", options.outputs,
                       "as for render, with --width one .png; default: output/<scene>-compare")
            ->type_name("OUT"));
    app.add_flag("--film,!--no-film", options.film, "draw it; default: on");
    app.add_flag("--strip,!--no-strip", options.strip, "a plot below the pictures; default: on");
    app.add_flag("--list", options.listOnly, "the built-in comparisons; default: off");
}

void addSweep(CLI::App& app, Options& options, RawOptions& raw) {
    addRuns(app, options, raw);
    app.add_option("--over", options.over,
                   "a setting and its values: KEY=1,4,16 or a range: 1..64, 1..64:x2, 0..1:0.25")
        ->type_name("KEY=RANGE");
    app.add_option("--csv", options.csv, "a row a value, all measures; default: not written")
        ->type_name("FILE|-");
    app.add_option("--plot", options.plot,
                   "the measures over the values, as .svg or .png; default: not drawn")
        ->type_name("FILE");
    takesAgain(
        app.add_option(
               "-o,--output", options.outputs,
               "a grid of up to 16 of the runs as a film, as for render, with --width as one "
               ".png; default: none")
            ->type_name("OUT"));
}

void addGallery(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    app.get_option("scene")
        ->expected(0, kMostScenes)
        ->required(false)
        ->description("built-in scenes or scene files; all: every built-in one; default: all");
    app.add_option("-o,--output", options.outputs,
                   "a folder: index.html, NAME.mp4, NAME.png, sheet.png; or the sheet alone: "
                   "a .png or -; default: output/gallery")
        ->type_name("DIR|FILE")
        ->expected(1);
    app.add_flag("--films,!--no-films", options.films, "films, not posters alone; default: on");
    app.add_option("--columns", options.columns,
                   "of the sheet: scenes in a row; default: 0, up to six, and all rows alike")
        ->type_name("N");
    addSeconds(app, options);
    addPicture(app, options, raw);
    app.get_option("--quality")->each([&options](const std::string&) {
        options.qualityAsked = true;
    });
    app.get_option("--size")->description(
        "pixels, 1..16384 a side; default: the quality's, 640x360 without one, 480x270 in a sheet");
    app.get_option("--fps")->description(
        "frames a second; the scene's steps a second must be a multiple; "
        "default: the quality's, or the next lower that is right");
    app.get_option("--overwrite")
        ->description("replace what differs from what was made before; default: off");
    app.add_option("-j,--jobs", options.jobs, "scenes at a time; default: 0, one a core")
        ->type_name("N");
    addFeedback(app, options);
}

void addWatch(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    app.add_flag("--once", options.once,
                 "one draft, then the end; default: off, until Ctrl-C (130)");
    app.add_option("-o,--output", options.outputs,
                   "a folder for draft.mp4 and draft.png; default: output/<scene>")
        ->type_name("DIR")
        ->expected(1);
    addSeconds(app, options);
    app.add_option("--size", raw.size, "pixels, 1..16384 a side; default: 480x270")
        ->type_name("WxH");
    takesList(
        app.add_option("--show", raw.show,
                       "overlays, with commas, see impulse render --help; default: the scene's")
            ->type_name("NAMES"));
    app.add_option("--theme", options.theme, "studio, dark or print; default: the scene's")
        ->type_name("NAME");
    app.add_option("--colour-by,--color-by", options.colorBy,
                   "what colours bodies, see impulse render --help; default: the scene's")
        ->type_name("NAME");
    app.add_option("--context", options.context,
                   "what gives OpenGL: osmesa, egl or auto, the first that works; default: auto")
        ->type_name("NAME");
    addFeedback(app, options);
}

}  // namespace

void addOptions(Command command, CLI::App& app, Options& options, RawOptions& raw) {
    switch (command) {
        case Command::render:
            return addRender(app, options, raw);
        case Command::still:
            return addStill(app, options, raw);
        case Command::strip:
            return addStrip(app, options, raw);
        case Command::sim:
            return addSim(app, options, raw);
        case Command::plot:
            return addPlot(app, options, raw);
        case Command::compare:
            return addCompare(app, options, raw);
        case Command::sweep:
            return addSweep(app, options, raw);
        case Command::exports:
            return addExport(app, options, raw);
        case Command::slides:
            return addSlides(app, options, raw);
        case Command::bench:
            return addBench(app, options, raw);
        case Command::doctor:
            return addFeedback(app, options);
        case Command::test:
            return addTest(app, options, raw);
        case Command::approve:
            return addApprove(app, options);
        case Command::watch:
            return addWatch(app, options, raw);
        case Command::gallery:
            return addGallery(app, options, raw);
        case Command::list:
            app.add_option("scene", options.scenes, "a scene to describe; default: all")
                ->type_name("SCENE")
                ->expected(0, kMostScenes);
            app.add_flag("--print", options.print, "the scene file itself; default: off");
            app.add_flag("--schema", options.schema,
                         "the JSON Schema of scene files, for editors; default: off");
            addFeedback(app, options);
            return;
        case Command::completion:
            app.add_option("shell", options.shell, "bash; default: bash")->type_name("SHELL");
            return;
    }
}

}  // namespace demos
