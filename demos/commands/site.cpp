#ifdef IMPULSE_HAVE_SLIDES
// impulse site: pages to read without a network, with the gallery.

#include "demos/site/site.h"

#include <fmt/format.h>

#include <filesystem>

#include "demos/commands/commands.h"
#include "demos/commands/gallery_choices.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

Exit site(const GalleryOptions& options) {
    const std::string target = options.outputs.empty() ? "" : options.outputs.front();
    const bool folder =
        std::filesystem::path(target).extension().empty() || std::filesystem::is_directory(target);
    if (target == "-" || !folder)
        refuse(fmt::format("--output '{}': a site goes to a folder", printable(target)));
    return siteInFolder(options);
}

Run addSite(CLI::App& app) {
    const auto asked = std::make_shared<Asked<GalleryOptions>>();
    addGalleryOptions(app, asked);
    app.get_option("--output")
        ->description("a folder for index.html, the other pages and gallery/; default: output/site")
        ->type_name("DIR");
    return [asked](const std::string& commandLine) {
        const GalleryOptions& given = settled(*asked, commandLine);
        checkRange("--columns", given.columns, 0, 100);
        return site(given);
    };
}

}  // namespace

Command siteCommand() {
    return {"site",
            "a folder of pages: the gallery, the tutorial, every key, a search; without a network",
            {"impulse site", "impulse site stack my.toml -o pages --no-films",
             "impulse site --jobs 1 --quiet"},
            addSite};
}

}  // namespace demos

#endif
