/// Where words and pictures of a slide stand.
#pragma once
#include "demos/slides/made_deck.h"

namespace demos {

enum class SlideLayout {
    opening,          // the title's slide
    openingPictured,  // with a picture on its right
    plain,            // words alone
    full,             // pictures alone
    beside,           // words on the left, two fifths of the width
    even,             // likewise, half of it: code or much text
    below             // words above what is wide: a strip, two pictures
};

SlideLayout layoutOf(const MadeSlide& slide);

}  // namespace demos
