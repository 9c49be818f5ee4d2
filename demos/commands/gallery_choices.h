/// The options of a gallery, alone or in a site.
#pragma once
#include "demos/commands/shared_options.h"
#include "demos/gallery/gallery_options.h"

namespace demos {

void addGalleryOptions(CLI::App& app, const std::shared_ptr<Asked<GalleryOptions>>& asked);

}  // namespace demos
