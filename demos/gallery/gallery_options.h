/// What `impulse gallery` is asked for.
#pragma once
#include "demos/options/options.h"

namespace demos {

struct GalleryOptions : Options {
    bool qualityAsked = false;  // it was given
    bool films = true;
    int columns = 0;  // of the sheet; 0 = up to six, all rows alike
};

}  // namespace demos
