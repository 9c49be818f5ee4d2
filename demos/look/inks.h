/// The colours of films, adapted for thin lines and small text.
#pragma once
#include <string>

#include "render/frame.h"

namespace demos {

struct Inks {
    render::Color ground;
    render::Color ink;    // titles
    render::Color muted;  // units, ticks, notes
    render::Color grid;
    render::Color axis;
};

/// `theme`: one of themeNames().
Inks inksOf(const std::string& theme);

/// The colour of the i-th line. Colour-blind viewers can distinguish the first six; after twelve
/// they repeat.
render::Color lineColor(int i, const Inks& inks);
/// The same for text.
render::Color labelColor(int i, const Inks& inks);

/// 1 (the same) to 21 (black on white), as WCAG 2.1 defines it.
double contrast(const render::Color& a, const render::Color& b);

}  // namespace demos
