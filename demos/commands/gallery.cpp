// impulse gallery: films and posters of scenes with a page of them, or one picture of all.

#include "demos/gallery/gallery.h"

#include <fmt/format.h>

#include <filesystem>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/gallery/gallery_sheet.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

Exit gallery(const GalleryOptions& options) {
    const std::string target = options.outputs.empty() ? "" : options.outputs.front();
    if (target == "-" || target.ends_with(".png")) return galleryOfOnePicture(options);
    if (const auto ending = std::filesystem::path(target).extension();
        !ending.empty() && !std::filesystem::is_directory(target))
        throw Stop(Exit::usage,
                   fmt::format("--output '{}': a gallery is a folder, or one picture, which ends "
                               "in .png or is -",
                               printable(target)));
    return galleryInFolder(options);
}

Run addGallery(CLI::App& app) {
    const auto asked = std::make_shared<Asked<GalleryOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
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
    addPicture(app, options, texts);
    app.get_option("--quality")->each([asked](const std::string&) {
        asked->options.qualityAsked = true;
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
    return [asked](const std::string& commandLine) {
        const GalleryOptions& given = settled(*asked, commandLine);
        checkRange("--columns", given.columns, 0, 100);
        return gallery(given);
    };
}

}  // namespace

Command galleryCommand() {
    return {"gallery",
            "films and posters of scenes with a page of them all, or one picture",
            {"impulse gallery", "impulse gallery stack my.toml -o site -q low",
             "impulse gallery -o scenes.png --size 240x135"},
            addGallery};
}

}  // namespace demos
