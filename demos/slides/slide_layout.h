/// Where words and pictures of a slide stand.
#pragma once
#include <vector>

#include "demos/slides/made_deck.h"
#include "demos/slides/slide_grid.h"

namespace demos {

enum class SlideLayout {
    opening,          // the title's slide
    openingPictured,  // with a picture on its right
    plain,            // words alone
    full,             // pictures alone
    beside,           // words on the left, two fifths of the width
    even,             // likewise, half of it: code, much text or a table and charts
    below             // words above what is wide: a strip, two pictures
};

/// How much room a slide's tables ask for.
enum class TableWidth {
    none,    // there are none
    narrow,  // they fit beside a picture
    half,    // they fit where that gets half the slide
    wide     // pictures go below them
};
TableWidth widthOf(const std::vector<MadeTable>& tables);

/// `aspects`: width over height of every picture.
SlideLayout layoutOf(const Slide& slide, TableWidth tables, const std::vector<double>& aspects);
SlideLayout layoutOf(const MadeSlide& slide);

/// What a layout leaves to pictures, about: words decide about the rest.
SlideRoom pictureRoom(SlideLayout layout, TableWidth tables);

}  // namespace demos
