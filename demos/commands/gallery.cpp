// impulse gallery: films and posters of scenes with a page that shows them, or one picture of all.

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
                   fmt::format("--output '{}': a gallery goes to a folder; one picture of all "
                               "scenes ends in .png or is -",
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
                   "a folder for index.html, NAME.mp4, NAME.png and sheet.png; or, for the sheet "
                   "alone, a .png or -; default: output/gallery")
        ->type_name("DIR|FILE")
        ->expected(1);
    app.add_flag("--films,!--no-films", options.films, "make films, not only posters; default: on");
    app.add_option("--columns", options.columns,
                   "scenes per row of the sheet; default: 0, up to six, rows as even as possible")
        ->type_name("N");
    addSeconds(app, options);
    addPicture(app, options, texts);
    app.get_option("--quality")->each([asked](const std::string&) {
        asked->options.qualityAsked = true;
    });
    app.get_option("--size")->description(
        "pixels, 1..16384 a side; default: the quality's; 640x360 without --quality, 480x270 in a "
        "sheet");
    app.get_option("--fps")->description(
        "frames per second; must divide the scene's steps per second; "
        "default: the quality's, or the next lower one that does");
    app.get_option("--overwrite")
        ->description("replace films and posters that are out of date; default: off");
    app.add_option("-j,--jobs", options.jobs, "scenes at a time; default: 0, one per core")
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
            "films and posters of scenes with a page that shows them, or one picture of all",
            {"impulse gallery", "impulse gallery stack my.toml -o site -q low",
             "impulse gallery -o scenes.png --size 240x135"},
            addGallery};
}

}  // namespace demos
