#include "demos/slides/slide_grid.h"

#include <algorithm>

namespace demos {
namespace {

constexpr double kCellGap = 20.0;  // px, as in page/slides.css

}  // namespace

PictureGrid gridOf(std::size_t count, int columns) {
    const int pictures = std::max(static_cast<int>(count), 1);
    return {(pictures + columns - 1) / columns, columns};
}

PictureGrid gridOf(std::size_t count, double aspect, const SlideRoom& room) {
    PictureGrid best = gridOf(count, 1);
    for (int columns = 2; columns <= static_cast<int>(count); ++columns) {
        const PictureGrid grid = gridOf(count, columns);
        if (shownWidth(aspect, cellOf(grid, room)) > shownWidth(aspect, cellOf(best, room)))
            best = grid;
    }
    return best;
}

SlideRoom cellOf(const PictureGrid& grid, const SlideRoom& room) {
    return {(room.width - (grid.columns - 1) * kCellGap) / grid.columns,
            (room.height - (grid.rows - 1) * kCellGap) / grid.rows};
}

double shownWidth(double aspect, const SlideRoom& room) {
    return std::min(room.width, room.height * aspect);
}

int emptyCells(std::size_t count, const PictureGrid& grid) {
    return grid.rows * grid.columns - std::max(static_cast<int>(count), 1);
}

}  // namespace demos
