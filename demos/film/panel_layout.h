/// Where the panels of a film lie.
#pragma once
#include <vector>

namespace demos {

/// Pixels, from the top left corner.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;
};

struct PanelLayout {
    int width = 0, height = 0;      // pixels, of the whole film
    std::vector<Area> panels;  // all of one size
    Area strip;                // of a plot; width 0 = none
};

/// One panel fills the film. Two stand side by side, with the plot below; three leave the fourth
/// corner to it; more make a grid as square as can be, with the plot below. Sizes are even, so
/// that every codec takes them.
PanelLayout panelLayout(int panels, bool strip, int width, int height);

/// A picture that keeps its size, with a plot of so many pixels below it: for paper, where a plot's
/// letters need the room.
PanelLayout layoutWithStrip(int width, int height, int strip);

}  // namespace demos
