/// Flat drawing on a picture, for charts: lines, rectangles and text, with exact coverage.
/// Positions are in pixels, (0, 0) is the picture's upper left corner, y points down. Parts outside
/// the picture are clipped; positions that are not finite are skipped.
#pragma once
#include <span>
#include <string>

#include "render/frame.h"
#include "render/image.h"

namespace render {

/// A position in a picture.
struct Point {
    float x = 0.0f, y = 0.0f;  // pixels
};

/// Fills an axis-aligned rectangle; its sides may lie between pixels.
void fillRectangle(Image& image, Point corner, float width, float height, const Color& color);

/// Draws one line through all points, `width` pixels wide, with round joints and ends. Where it
/// crosses itself, a translucent colour is blended once. A point that is not finite leaves a gap.
void drawPolyline(Image& image, std::span<const Point> points, float width, const Color& color);

/// The part of a text that is at its position: start, middle or end.
enum class Anchor { start, middle, end };

/// Tabular figures are all as wide as the widest, so that a running number does not jitter.
enum class Figures { proportional, tabular };

/// Draws one line of UTF-8 text. `at`: the anchor, on the baseline. `pixels`: height from cap to
/// descender.
void drawLabel(Image& image, const std::string& text, Point at, Anchor anchor, float pixels,
               const Color& color, Figures figures = Figures::proportional);

}  // namespace render
