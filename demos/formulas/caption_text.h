/// Captions: texts of one line with formulas between dollars.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "render/formula.h"

namespace demos {

constexpr std::size_t kMostCaptionFormulas = 1000;  // of a scene

/// A caption, as letters and as it is drawn.
struct CaptionText {
    std::string letters;  // formulas in ordinary letters, scripts as Unicode's small letters or after ^ and _
    std::string line;     // formulas are characters, as in render::Text; broken at a space
    std::vector<render::Formula> formulas;
    std::vector<std::string> markup;  // of each, with its dollars; empty: it goes on with the one before
};

/// The character of formula k in a line.
std::string formulaMark(std::size_t k);

/// Throws FormulaError with the byte of the text.
CaptionText captionText(const std::string& text);

}  // namespace demos
