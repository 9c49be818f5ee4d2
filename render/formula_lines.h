/// Lines of words and formulas.
#pragma once
#include <span>
#include <string>

#include "render/canvas.h"
#include "render/formula.h"
#include "render/image.h"

namespace render {

/// Width in pixels at a cap-to-descender height of `pixels`, as textWidth().
float lineWidth(const std::string& line, std::span<const Formula> formulas, int pixels);

/// How far the formulas of a line reach above its letters, and below, in pixels.
struct LineReach {
    float above = 0.0f, below = 0.0f;
};
LineReach lineReach(const std::string& line, std::span<const Formula> formulas, int pixels);

/// `at`: the left end, on the baseline. Without a halo.
void drawFormulaLine(Image& image, const std::string& line, std::span<const Formula> formulas, int pixels,
                     Point at, const Color& color);

}  // namespace render
