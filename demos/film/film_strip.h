/// Moments of a film side by side, each with its time below: for paper and slides.
#pragma once
#include <string>

#include "demos/options.h"
#include "demos/report/inks.h"
#include "render/image.h"

namespace demos {

/// Pixels.
struct StripLayout {
    int moments = 0, columns = 0, rows = 0;
    PictureSize picture;
    int gap = 0;    // around every picture
    int label = 0;  // height of a line of text; 0 = none
    int width = 0, height = 0;

    int left(int moment) const { return gap + moment % columns * (picture.width + gap); }
    int top(int moment) const {
        return gap + moment / columns * (picture.height + labelRoom() + gap);
    }
    int labelRoom() const { return label > 0 ? label + label / 2 : 0; }
};

/// `columns` 0: up to six, as even as can be. Throws Stop (usage) where the whole would be larger
/// than a PNG may be.
StripLayout stripLayout(int moments, int columns, PictureSize picture, bool labels);

/// The empty paper.
render::Image stripPaper(const StripLayout& layout, const render::Color& ground);

/// Puts a picture in its place, its label in the middle below it.
void placeMoment(const StripLayout& layout, int moment, const render::Image& picture,
                 const std::string& label, const render::Color& ink, render::Image& paper);

}  // namespace demos
