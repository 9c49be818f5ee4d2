/// impulse gallery: every scene's film and poster in a folder, and a page of them all.
#pragma once
#include "demos/gallery/gallery_options.h"
#include "demos/text/stop.h"

namespace demos {

/// What a scene that fails leaves out is reported; the others are made. The code of the first
/// failure. Throws Stop (wouldOverwrite, interrupted), render::Error.
Exit galleryInFolder(const GalleryOptions& options);

}  // namespace demos
