#include "demos/options_testing.h"

#include "demos/options_groups.h"

namespace demos {

void addTest(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    app.get_option("scene")
        ->expected(0, kMostScenes)
        ->required(false)
        ->description(
            "built-in scenes, scene files or folders of them; default: all built-in ones");
    app.add_option("--baselines", options.baselines,
                   "the folder of all NAME.snapshots; default: beside each scene file, and "
                   "snapshots/ for built-in scenes")
        ->type_name("DIR");
    app.add_option("-o,--output", options.outputs,
                   "a folder for the report and what was drawn; default: output/test")
        ->type_name("DIR")
        ->expected(1);
    app.add_option("--update", options.update,
                   "which baselines are written: missing, changed (and missing), all or none; "
                   "default: missing, and none where CI=true; with none a missing one fails")
        ->type_name("WHICH");
    app.add_flag("--cache,!--no-cache", options.cache,
                 "leave out what has passed and not changed since; default: on");
    app.add_flag("--self-test", options.selfTest,
                 "damage every picture on purpose and tell what would be noticed; default: off");
    app.add_option("--size", raw.size,
                   "pixels, 1..16384 a side; default: the scene's [snapshot] size")
        ->type_name("WxH");
    addRenderer(app, options);
    app.add_option("-j,--jobs", options.jobs, "scenes at a time; default: 0, one a core")
        ->type_name("N");
    addFeedback(app, options);
}

void addApprove(CLI::App& app, Options& options) {
    app.add_option("name", options.scenes,
                   "a scene, one picture (NAME@TIME) or its physics (NAME@physics)")
        ->type_name("NAME")
        ->expected(0, kMostScenes);
    app.add_flag("--all", options.all,
                 "everything that the last test found different; default: off");
    app.add_flag("--prune", options.prune,
                 "remove baselines that no scene asks for any more; default: off");
    app.add_option("--results", options.results, "the folder of impulse test; default: output/test")
        ->type_name("DIR");
    addFeedback(app, options);
}

void addBench(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    app.get_option("scene")->expected(0, kMostScenes)->required(false);
    addSeconds(app, options);
    app.add_flag("--film", options.benchFilm,
                 "processor time of every stage of a frame, and frames/s, of the film as it would "
                 "be rendered with the options below; default: off");
    addPicture(app, options, raw);
    addJobs(app, options);
    app.add_flag("--phases", options.phases,
                 "ms of every phase of the step, from a second run; default: off");
    app.add_option("--against", options.against,
                   "compare with an earlier 'impulse bench --json > FILE'; default: none")
        ->type_name("FILE");
    addFeedback(app, options);
}

}  // namespace demos
