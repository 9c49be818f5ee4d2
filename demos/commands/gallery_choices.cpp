#include "demos/commands/gallery_choices.h"

namespace demos {
namespace {

void describePicture(CLI::App& app) {
    app.get_option("--size")->description(
        "pixels, 1..16384 a side; default: the quality's; 640x360 without --quality, 480x270 in a "
        "sheet");
    app.get_option("--fps")->description(
        "frames per second; must divide the scene's steps per second; "
        "default: the quality's, or the next lower one that does");
    app.get_option("--overwrite")
        ->description("replace films, posters and replays that are out of date; default: off");
}

}  // namespace

void addGalleryOptions(CLI::App& app, const std::shared_ptr<Asked<GalleryOptions>>& asked) {
    GalleryOptions& options = asked->options;
    addSceneChoice(app, options, asked->texts);
    app.get_option("scene")
        ->expected(0, kMostScenes)
        ->required(false)
        ->description("built-in scenes or scene files; all: every built-in one; default: all");
    app.add_option("-o,--output", options.outputs)->expected(1);
    app.add_flag("--films,!--no-films", options.films, "make films, not only posters; default: on");
    app.add_flag("--replays,!--no-replays", options.replays,
                 "make a page of each scene to step through its run; default: on");
    app.add_option("--columns", options.columns,
                   "scenes per row of the sheet; default: 0, up to six, rows as even as possible")
        ->type_name("N");
    addSeconds(app, options);
    addPicture(app, options, asked->texts);
    app.get_option("--quality")->each([asked](const std::string&) {
        asked->options.qualityAsked = true;
    });
    describePicture(app);
    app.add_option("-j,--jobs", options.jobs, "scenes at a time; default: 0, one per core")
        ->type_name("N");
    addFeedback(app, options);
}

}  // namespace demos
