/// Arranges pictures of one shape in rows and columns, as large as possible.
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

/// The grid of `count` pictures with this number of columns.
PictureGrid gridOf(std::size_t count, int columns);

/// The grid with the largest pictures. `aspect`: their width over height.
PictureGrid gridOf(std::size_t count, double aspect, const SlideRoom& room);

/// The size of one cell, without the gap.
SlideRoom cellOf(const PictureGrid& grid, const SlideRoom& room);

/// The width of a picture in a space, pixels of a slide.
double shownWidth(double aspect, const SlideRoom& room);

/// Empty cells of the last row.
int emptyCells(std::size_t count, const PictureGrid& grid);

}  // namespace demos
