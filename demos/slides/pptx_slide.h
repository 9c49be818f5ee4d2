/// A slide of a .pptx, and its notes.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "demos/slides/measured_slide.h"
#include "demos/slides/pptx_package.h"

namespace demos {

/// The names of a slide's film and pictures, relative to the slide.
struct PptxSlideFiles {
    std::string film;        // "": none
    std::vector<std::string> pictures;  // as picturesOf()
};

/// `formula` keeps the picture of a formula and returns its name, relative to the slide. Adds to
/// `relations` what the slide refers to. Throws FormulaError.
std::string pptxSlideXml(const Deck& deck, const MadeSlide& made, const MeasuredSlide& measured,
                         const PptxSlideFiles& files, PptxRelations& relations,
                         const std::function<std::string(const MeasuredFormula&)>& formula);

/// The page of notes of a slide: what the speaker says, and the command that makes its picture.
std::string pptxNotesXml(const MadeSlide& made, PptxRelations& relations);

}  // namespace demos
