/// The layout of a slide's words and pictures.
#pragma once
#include <vector>

#include "demos/slides/made_deck.h"
#include "demos/slides/slide_grid.h"

namespace demos {

enum class SlideLayout {
    opening,          // the title slide
    openingPictured,  // with a picture on its right
    plain,            // only words
    full,             // only pictures
    beside,           // words on the left, two fifths of the width
    even,             // words on the left, half of the width: code, much text or a table and charts
    below             // words above wide pictures: a strip, two pictures
};

/// How much space a slide's tables need.
enum class TableWidth {
    none,    // there are none
    narrow,  // they fit beside a picture
    half,    // they fit beside a picture of half the slide
    wide     // pictures go below them
};
TableWidth widthOf(const std::vector<MadeTable>& tables);

/// `aspects`: width over height of every picture.
SlideLayout layoutOf(const Slide& slide, TableWidth tables, const std::vector<double>& aspects);
SlideLayout layoutOf(const MadeSlide& slide);

/// About the space that a layout leaves for pictures: it also depends on the words.
SlideRoom pictureRoom(SlideLayout layout, TableWidth tables);

}  // namespace demos
