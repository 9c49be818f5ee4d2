/// Pictures of one shape side by side, over the whole width of a figure, with labels below.
#pragma once
#include <string>
#include <vector>

#include "demos/film/film_strip.h"
#include "demos/look/paper.h"

namespace demos {

/// In a row, so that every picture is wide enough for its label; all rows alike.
int figureColumns(int pictures, const Paper& paper);

/// `ratio`: of one picture; `lines`: of a label, 0 = none. The outer pictures touch the figure's
/// edges. Throws Stop (usage) where the whole would be larger than a PNG may be.
StripLayout figureLayout(int pictures, int columns, PictureSize ratio, const Paper& paper,
                         int lines);

/// Throws Stop (usage) where it is larger than a PNG may be, or has pictures too small to see.
void checkLayout(const StripLayout& layout, const Paper& paper);

/// The text in lines as wide as a picture.
std::vector<std::string> labelLines(const std::string& text, const StripLayout& layout);

/// "(a)", "(b)", ...
std::string panelLetter(int panel);

}  // namespace demos
