#include "demos/slides/slide_arrangement.h"

#include <algorithm>

#include "demos/look/type.h"

namespace demos {
namespace {

constexpr double kChartAspect = 1.6;                     // width over height, if there is room
constexpr double kNarrowChart = 1.35, kWideChart = 2.2;  // limits of width over height
constexpr double kHoleIsWorth = 1.35;  // empty cells must make the pictures wider by this factor

/// The number of columns is not known yet: a table of measures has one per measure.
TableWidth plannedTables(const Slide& slide) {
    if (slide.measures) return TableWidth::wide;
    return slide.expectations ? TableWidth::half : TableWidth::none;
}

SlideRoom roomOf(const Slide& slide, TableWidth tables, const std::vector<double>& aspects) {
    const SlideRoom room = pictureRoom(layoutOf(slide, tables, aspects), tables);
    const double least = *std::min_element(aspects.begin(), aspects.end());
    return cellOf(gridOf(aspects.size(), least, room), room);
}

/// The width of one of the pictures, px of a slide.
double partWidth(const Slide& slide, const PictureGrid& grid, double aspect) {
    const double whole = aspect * grid.columns / grid.rows;
    return shownWidth(whole, exhibitRoom(slide, whole)) / grid.columns;
}

}  // namespace

bool standsAlone(const Slide& slide) {
    return slide.text.empty() && slide.formulas.empty() && slide.code.empty() &&
           slide.plots.empty() && !slide.measures && !slide.expectations;
}

SlideLayout plannedLayout(const Slide& slide) {
    std::vector<double> aspects(slide.plots.size(), kChartAspect);
    if (slide.exhibit != Exhibit::none) aspects.push_back(kChartAspect);
    return layoutOf(slide, plannedTables(slide), aspects);
}

SlideRoom exhibitRoom(const Slide& slide, double aspect) {
    std::vector<double> aspects(slide.plots.size(), kChartAspect);
    aspects.push_back(aspect);
    return roomOf(slide, plannedTables(slide), aspects);
}

PictureGrid arrangement(const Slide& slide, std::size_t count, double aspect) {
    PictureGrid best{1, std::max(static_cast<int>(count), 1)};
    double most = partWidth(slide, best, aspect);
    for (int columns = best.columns - 1; columns >= 1; --columns) {
        const PictureGrid grid = gridOf(count, columns);
        if (grid.rows > grid.columns) break;
        const double hole = emptyCells(count, grid) > 0 ? kHoleIsWorth : 1.0;
        const double width = partWidth(slide, grid, aspect) / hole;
        if (width <= most) continue;
        best = grid;
        most = width;
    }
    return best;
}

double pointPixels(const Slide& slide, PictureSize picture) {
    const double aspect = static_cast<double>(picture.width) / picture.height;
    const double shown = shownWidth(aspect, exhibitRoom(slide, aspect));
    return kLeastLetters / kLabelPoints * picture.width / shown;
}

SlideRoom chartRoom(const Slide& slide, const std::vector<MadeTable>& tables, std::size_t count,
                    std::optional<double> exhibit) {
    std::vector<double> aspects(count, kChartAspect);
    if (exhibit) aspects.push_back(*exhibit);
    const SlideRoom cell = roomOf(slide, widthOf(tables), aspects);
    return {std::min(cell.width, kWideChart * cell.height),
            std::min(cell.height, cell.width / kNarrowChart)};
}

}  // namespace demos
