#include "demos/film/panel_layout.h"

namespace demos {
namespace {

constexpr double kStripShare = 0.3;  // of the height, for a plot below the panels

int columnsFor(int panels) {
    int columns = 1;
    while (columns * columns < panels) ++columns;
    return columns;
}

}  // namespace

PanelLayout panelLayout(int panels, bool strip, int width, int height) {
    PanelLayout layout{width, height, {}, {}};
    if (panels == 1 && !strip) {
        layout.panels = {{0, 0, width, height}};
        return layout;
    }
    const int columns = columnsFor(panels), rows = (panels + columns - 1) / columns;
    const bool freeCorner = panels == 3;
    const bool below = strip && !freeCorner;
    const int forPanels = below ? static_cast<int>((1.0 - kStripShare) * height) : height;
    const int w = width / columns, h = forPanels / rows;
    for (int i = 0; i < panels; ++i)
        layout.panels.push_back({i % columns * w, i / columns * h, w, h});
    if (below) layout.strip = {0, rows * h, width, height - rows * h};
    if (strip && freeCorner) layout.strip = {w, h, w, h};
    return layout;
}

PanelLayout layoutWithStrip(int width, int height, int strip) {
    return {width, height + strip, {{0, 0, width, height}}, {0, height, width, strip}};
}

}  // namespace demos
