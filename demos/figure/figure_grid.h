/// Pictures of one shape side by side, over the whole width of a figure, with labels below.
#pragma once
#include <string>
#include <vector>

#include "demos/film/film_strip.h"
#include "demos/look/paper.h"

namespace demos {

/// Pictures in a row: each is wide enough for its label, and rows are even.
int figureColumns(int pictures, const Paper& paper);

/// `ratio`: of one picture; `lines`: of a label, 0 = none. The outer pictures touch the figure's
/// edges. Throws Stop (usage) if the whole would be too large for a PNG.
StripLayout figureLayout(int pictures, int columns, PictureSize ratio, const Paper& paper,
                         int lines);

/// Throws Stop (usage) if it is too large for a PNG or its pictures are too small to see.
void checkLayout(const StripLayout& layout, const Paper& paper);

/// The text broken into lines no wider than a picture.
std::vector<std::string> labelLines(const std::string& text, const StripLayout& layout);

/// "(a)", "(b)", ...
std::string panelLetter(int panel);

}  // namespace demos
