/// Where texts, plates and names go on a picture: nothing over anything else, nothing beyond the
/// margins. The order is the priority; what has no room is left out.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "render/frame.h"

namespace render {

/// Pixels, y down.
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
    int pixels = 0;  // of a line's cap-to-descender height
    float lineHeight = 0;
    bool right = false;  // lines end at the box's right edge
    Color color;
};

/// A plate's columns.
struct PlateMetrics {
    int pixels = 0;  // as a text's
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

/// Pixels from a picture's edge to what stands in its corners.
float cornerMargin(int width, int height);
/// Pixels of a text's cap-to-descender height, for its size in a picture of 1280x720.
int textPixels(float size, const Look& look, int width, int height);

/// The text in lines of at most `room` pixels; a word that is wider loses its end.
std::vector<std::string> brokenText(const std::string& text, int pixels, float room);

/// Pixels of a metre where the camera looks.
float pixelsPerMeter(const Camera& camera, int height);

PlateMetrics metricsOf(const Plate& plate, int pixels, float pixelsPerMeter);  // plate.cpp

}  // namespace render
