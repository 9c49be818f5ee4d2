// impulse gallery: films and posters of scenes with a page that shows them, or one picture of all.

#include "demos/gallery/gallery.h"

#include <fmt/format.h>

#include <filesystem>

#include "demos/commands/commands.h"
#include "demos/commands/gallery_choices.h"
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
    return galleryInFolder(options).code;
}

Run addGallery(CLI::App& app) {
    const auto asked = std::make_shared<Asked<GalleryOptions>>();
    addGalleryOptions(app, asked);
    app.get_option("--output")
        ->description(
            "a folder for index.html, NAME.mp4, NAME.png, NAME.html and sheet.png; or, for the "
            "sheet alone, a .png or -; default: output/gallery")
        ->type_name("DIR|FILE");
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
