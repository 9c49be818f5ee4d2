/// Flat drawing on a picture, for charts: lines, rectangles and text, with exact coverage.
/// Places are in pixels, (0, 0) the picture's upper left corner, y down; what lies outside is cut
/// off, what is not finite is left out.
#pragma once
#include <span>
#include <string>

#include "render/frame.h"
#include "render/image.h"

namespace render {

/// A place in a picture.
struct Point {
    float x = 0.0f, y = 0.0f;  // pixels
};

/// An axis-aligned rectangle; sides may lie between pixels.
void fillRectangle(Image& image, Point corner, float width, float height, const Color& color);

/// One line through all points, `width` pixels wide, with round joints and ends. Where it crosses
/// itself a translucent colour counts once. A point that is not finite leaves a gap.
void drawPolyline(Image& image, std::span<const Point> points, float width, const Color& color);

/// Which part of a text is at its place: start, middle or end.
enum class Anchor { start, middle, end };

/// One line of UTF-8 text; `at`: its anchor on the baseline. `pixels` from cap to descender.
void drawLabel(Image& image, const std::string& text, Point at, Anchor anchor, float pixels,
               const Color& color);

}  // namespace render
