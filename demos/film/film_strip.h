/// Moments of a film side by side, each with its time below: for paper and slides.
#pragma once
#include <string>
#include <vector>

#include "demos/look/inks.h"
#include "demos/options/options.h"
#include "render/canvas.h"
#include "render/image.h"

namespace demos {

/// Pixels.
struct StripLayout {
    int moments = 0, columns = 0, rows = 0;
    PictureSize picture;
    int margin = 0;  // around all of them
    int gap = 0;     // between two
    int label = 0;   // height of a line of text; 0 = none
    int lines = 1;   // of text below each
    int width = 0, height = 0;

    /// The outer pictures touch the margins; the gaps take the remainder of the division.
    int left(int moment) const {
        const int last = columns > 1 ? columns - 1 : 1;
        return margin + moment % columns * (width - 2 * margin - picture.width) / last;
    }
    int top(int moment) const {
        return margin + moment / columns * (picture.height + labelRoom() + gap);
    }
    int lineHeight() const { return label + label / 5; }
    int labelRoom() const { return label > 0 ? label + label / 2 + (lines - 1) * lineHeight() : 0; }
};

/// `columns` 0: up to six, in rows as even as possible. Throws Stop (usage) if the strip would be
/// too large for a PNG.
StripLayout stripLayout(int moments, int columns, PictureSize picture, bool labels);

/// Empty paper.
render::Image stripPaper(const StripLayout& layout, const render::Color& ground);

/// Puts a picture in its place.
void placePicture(const StripLayout& layout, int moment, const render::Image& picture,
                  render::Image& paper);

/// Lines of text below a picture, centred or from its left edge.
void placeLines(const StripLayout& layout, int moment, const std::vector<std::string>& lines,
                render::Anchor anchor, const render::Color& ink, render::Image& paper);

/// Puts a picture in its place, with its label centred below it, shrunk if it is too wide.
void placeMoment(const StripLayout& layout, int moment, const render::Image& picture,
                 const std::string& label, const render::Color& ink, render::Image& paper);

}  // namespace demos
