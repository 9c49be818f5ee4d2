/// Layout of texts and plates in the corners of a picture: they do not overlap and stay within the
/// margins. Earlier items have priority; an item without room is left out.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/frame.h"

namespace render {

/// A rectangle in pixels, y down.
struct Box {
    float x = 0, y = 0, width = 0, height = 0;
    bool overlaps(const Box& o) const {
        return x < o.x + o.width && o.x < x + width && y < o.y + o.height && o.y < y + height;
    }
};

/// A text broken into lines that fit.
struct PlacedText {
    Box box;
    std::vector<std::string> lines;
    std::span<const Formula> formulas;
    int pixels = 0;  // cap-to-descender height of a line
    float lineHeight = 0;
    float above = 0;  // by which formulas reach above the letters of a line
    bool right = false;  // lines end at the box's right edge
    float pad = 0;       // from the plate's edge to the letters; 0: no plate
    Color color;
    std::string heading;  // above the lines; empty: none
    int headingPixels = 0;
    float headingHeight = 0;
    Color headingColor;
};

/// The measurements of a plate, in pixels.
struct PlateMetrics {
    int pixels = 0;  // as for a text
    float pad = 0, swatch = 0, gap = 0, row = 0, bar = 0;
    float width = 0, height = 0;
};

struct PlacedPlate {
    Box box;
    PlateMetrics metrics;
    const Plate* plate = nullptr;
};

struct CornerLayout {
    std::vector<PlacedText> texts;
    std::vector<PlacedPlate> plates;
    bool isFree(const Box& box) const;
};

/// The result points into the frame.
CornerLayout layoutCorners(const Frame& frame, int width, int height);

/// Pixels from a picture's edge to the texts and plates in its corners.
float cornerMargin(int width, int height);
/// Cap-to-descender height in pixels of a text with this size in a picture of 1280x720.
int textPixels(float size, const Look& look, int width, int height);

/// Breaks the text into lines of at most `room` pixels; the end of a wider word is cut off.
std::vector<std::string> brokenText(const std::string& text, int pixels, float room,
                                    std::span<const Formula> formulas = {});

/// Pixels per metre at the point the camera looks at.
float pixelsPerMeter(const Camera& camera, int height);

PlateMetrics metricsOf(const Plate& plate, int pixels, float pixelsPerMeter);  // plate.cpp

}  // namespace render
