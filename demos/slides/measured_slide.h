/// Where a browser places the parts of a slide, for formats that need every place.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// Left, top, width and height: px of a slide of 1280x720.
struct SlideBox {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

struct MeasuredWords {
    SlideBox box;
    double size = 0.0, line = 0.0;  // px: of the letters, from line to line
    bool centered = false;
};

struct MeasuredFormula {
    SlideBox box;
    std::string tex;
    std::vector<std::uint8_t> png;  // four pixels per px, on a transparent ground
};

/// A part of a slide's text: a paragraph, a list.
struct MeasuredBlock {
    MeasuredWords words;
    std::optional<MeasuredFormula> formula;  // it is nothing else
};

struct MeasuredTable {
    MeasuredWords words;
    std::vector<double> columns, rows;  // px
};

/// In the order of the slide's parts; the first three hold at most one.
struct MeasuredSlide {
    std::vector<MeasuredWords> title, caption, code;
    std::vector<MeasuredWords> under;  // the opening's: subtitle, authors
    std::vector<MeasuredBlock> blocks;
    std::vector<MeasuredFormula> formulas;
    std::vector<MeasuredTable> tables;
    std::vector<SlideBox> pictures;
};

/// Lets `program`, a Chromium, lay out the deck in the typefaces of a .pptx. Throws FormulaError,
/// and render::Error with how it failed.
std::vector<MeasuredSlide> measuredSlides(const MadeDeck& deck, const std::string& program);

}  // namespace demos
