// impulse gallery: films and posters of scenes with a page of them, or one picture of all.

#include "demos/gallery/gallery.h"

#include <fmt/format.h>

#include <filesystem>

#include "demos/commands/commands.h"
#include "demos/gallery/gallery_sheet.h"
#include "demos/scene/complaints.h"

namespace demos {

Exit galleryCommand(const Options& options) {
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

}  // namespace demos
