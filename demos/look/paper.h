/// The paper of a figure: its width in mm and pixels, and the sizes of type and lines.
#pragma once

namespace demos {

struct PictureSize {
    int width = 0, height = 0;  // pixels
};

struct Paper {
    double width = 0.0;  // mm; 0: the picture is for a screen
    int dpi = 300;       // pixels per inch
    double type = 1.0;   // on a screen: scale of letters and lines of charts

    bool given() const { return width > 0.0; }
    /// 0 for a screen.
    double pixelsPerPoint() const { return given() ? dpi / 72.0 : 0.0; }
    int pixels() const { return pixelsOf(width); }
    int pixelsOf(double millimetres) const;
    double millimetresOf(int pixels) const { return 25.4 * pixels / dpi; }
};

/// The size of a figure with the paper's width and this ratio. Throws Stop (usage) if it is higher
/// than a picture can be, or too low.
PictureSize figureSize(const Paper& paper, PictureSize ratio);

}  // namespace demos
