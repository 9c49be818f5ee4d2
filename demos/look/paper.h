/// Where a figure goes: a width on paper, the pixels that it is, and the sizes of type and lines.
#pragma once

namespace demos {

struct PictureSize {
    int width = 0, height = 0;  // pixels
};

struct Paper {
    double width = 0.0;  // mm; 0: the picture is for a screen
    int dpi = 300;       // pixels an inch
    double type = 1.0;   // on a screen: letters and lines of charts so many times as large

    bool given() const { return width > 0.0; }
    /// 0 for a screen.
    double pixelsPerPoint() const { return given() ? dpi / 72.0 : 0.0; }
    int pixels() const { return pixelsOf(width); }
    int pixelsOf(double millimetres) const;
    double millimetresOf(int pixels) const { return 25.4 * pixels / dpi; }
};

/// As wide as the paper says, of the ratio given. Throws Stop (usage) where it is higher than a
/// picture can be.
PictureSize figureSize(const Paper& paper, PictureSize ratio);

}  // namespace demos
