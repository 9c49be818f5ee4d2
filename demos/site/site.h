/// impulse site: a folder of pages to read without a network: the gallery with its films and
/// replays, the project's texts for readers, every key of a scene file, and a search over all of
/// them.
#pragma once
#include "demos/gallery/gallery_options.h"
#include "demos/text/stop.h"

namespace demos {

/// `options`: of the gallery; their output is the site's folder, output/site by default. Returns
/// the code of the first scene that fails. Throws Stop (wouldOverwrite, interrupted),
/// render::Error.
Exit siteInFolder(const GalleryOptions& options);

}  // namespace demos
