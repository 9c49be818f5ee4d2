/// A slide as HTML: its words, its pictures, its notes.
#pragma once
#include <string>

#include "demos/slides/slide_media.h"

namespace demos {

/// `number`: from 1. Throws FormulaError.
std::string slideHtml(const Deck& deck, const MadeSlide& slide, std::size_t number,
                      const SlideMedia& media);

}  // namespace demos
