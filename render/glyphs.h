/// Letters as bitmaps: exact coverage at every size, with a soft halo that sets them off from any
/// ground. Both are made once for every letter and size.
#pragma once
#include <string>
#include <vector>

#include "render/frame.h"
#include "render/image.h"

namespace render {

constexpr int kSmallestText = 11;  // pixels of cap-to-descender height; smaller is not legible

/// Width in pixels that a line of text takes at a cap-to-descender height of `pixels`.
float textWidth(const std::string& text, float pixels);

/// Of UTF-8; a broken byte, or one of control, is a question mark.
std::vector<int> codepoints(const std::string& text);

/// From the top of a line to its baseline: pixels.
float textAscent(int pixels);

/// One line that begins at x, with a halo of the opposite lightness.
void drawHaloed(Image& image, const std::string& text, int pixels, float x, float baseline,
                const Color& color);

}  // namespace render
