/// impulse gallery: every scene's film and poster in a folder, and a page of all of them.
#pragma once
#include "demos/gallery/gallery_options.h"
#include "demos/text/stop.h"

namespace demos {

/// Reports a scene that fails and makes the others. Returns the code of the first failure. Throws
/// Stop (wouldOverwrite, interrupted), render::Error.
Exit galleryInFolder(const GalleryOptions& options);

}  // namespace demos
