/// The options of `impulse gallery`.
#pragma once
#include "demos/options/options.h"

namespace demos {

struct GalleryOptions : Options {
    bool qualityAsked = false;  // --quality was given
    bool films = true;
    int columns = 0;  // of the sheet; 0 = up to six, in even rows
};

}  // namespace demos
