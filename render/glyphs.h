/// Letters as bitmaps with exact coverage at every size, and a soft halo that makes them legible on
/// any background. Both are made once per letter and size; letters of formulas are made each time.
#pragma once
#include <string>
#include <vector>

#include "render/canvas.h"
#include "render/frame.h"
#include "render/image.h"

namespace render {

/// The font's em per height of a line, from cap to descender.
constexpr double kEmShare = 2048.0 / 2384.0;

constexpr int kSmallestText = 11;  // pixels of cap-to-descender height; smaller is not legible

/// Width in pixels of a line of text at a cap-to-descender height of `pixels`.
float textWidth(const std::string& text, float pixels, Figures figures = Figures::proportional);

/// The code points of UTF-8 text; an invalid byte or a control character becomes a question mark.
std::vector<int> codepoints(const std::string& text);

/// Pixels from the top of a line to its baseline.
float textAscent(int pixels);

/// A letter's extents in em, from its left end on the baseline.
struct LetterExtent {
    float advance = 0.0f;
    float left = 0.0f, right = 0.0f, bottom = 0.0f, top = 0.0f;  // of its ink; y points up
};
LetterExtent letterExtent(int codepoint, bool italic);
/// Whether a font has the letter.
bool hasLetter(int codepoint);

/// Draws a letter of a formula. `pixels`: of the text; `at`: its left end, on its baseline.
void drawLetter(Image& image, const FormulaLetter& letter, float pixels, Point at, const Color& color);

/// Draws one line that begins at x, with a halo of the opposite lightness.
void drawHaloed(Image& image, const std::string& text, int pixels, float x, float baseline,
                const Color& color);

}  // namespace render
