/// Pictures of one shape in rows and columns, as large as their room lets them be.
#pragma once
#include <cstddef>

namespace demos {

/// Pixels of a slide of 1280x720.
struct SlideRoom {
    double width = 0.0, height = 0.0;
};

struct PictureGrid {
    int rows = 1, columns = 1;
};

/// The cells that `count` pictures need in so many columns.
PictureGrid gridOf(std::size_t count, int columns);

/// Whose pictures are largest. `aspect`: their width over height.
PictureGrid gridOf(std::size_t count, double aspect, const SlideRoom& room);

/// One cell, a gap away from the next.
SlideRoom cellOf(const PictureGrid& grid, const SlideRoom& room);

/// Pixels of a slide: how wide a picture is shown.
double shownWidth(double aspect, const SlideRoom& room);

/// Empty cells of the last row.
int emptyCells(std::size_t count, const PictureGrid& grid);

}  // namespace demos
