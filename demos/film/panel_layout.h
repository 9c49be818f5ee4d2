/// The places of a film's panels.
#pragma once
#include <vector>

namespace demos {

/// Pixels, from the top left corner.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;
};

struct PanelLayout {
    int width = 0, height = 0; // pixels, of the whole film
    std::vector<Area> panels;  // all of one size
    Area strip;                // of a plot; width 0 = none
};

/// One panel fills the film. Two are side by side, with the plot below; three leave the fourth
/// corner to the plot; more make a grid as square as possible, with the plot below. What a grid of equal
/// panels leaves over of the size, a few pixels on the right and below, stays empty.
PanelLayout panelLayout(int panels, bool strip, int width, int height);

/// A picture that keeps its size, with a plot of `strip` pixels below it: for paper, where a plot's
/// letters need the room.
PanelLayout layoutWithStrip(int width, int height, int strip);

}  // namespace demos
