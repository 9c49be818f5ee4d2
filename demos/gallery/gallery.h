/// impulse gallery: every scene's film and poster in a folder, and a page of all of them.
#pragma once
#include <vector>

#include "demos/gallery/gallery_card.h"
#include "demos/gallery/gallery_options.h"
#include "demos/text/stop.h"

namespace demos {

struct GalleryMade {
    Exit code = Exit::ok;            // of the first failure
    std::vector<GalleryCard> cards;  // of the scenes on the page, in its order
};

/// Reports a scene that fails and makes the others. Throws Stop (wouldOverwrite, interrupted),
/// render::Error.
GalleryMade galleryInFolder(const GalleryOptions& options);

}  // namespace demos
