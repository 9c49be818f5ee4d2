/// The options of `impulse gallery`.
#pragma once
#include <string>
#include <vector>

#include "demos/options/options.h"

namespace demos {

/// A link at the head of the page.
struct GalleryLink {
    std::string text, address;
};

struct GalleryOptions : Options {
    bool qualityAsked = false;  // --quality was given
    bool films = true;
    bool replays = true;
    int columns = 0;                 // of the sheet; 0 = up to six, in even rows
    std::vector<GalleryLink> links;  // to the other pages of a site
};

}  // namespace demos
