#include "demos/slides/slide_layout.h"

#include <algorithm>

#include "demos/slides/slide_media.h"

namespace demos {
namespace {

constexpr double kWide = 2.6;            // width over height, as of a strip
constexpr std::size_t kLongText = 360;   // bytes
constexpr std::size_t kNarrowTable = 4;  // columns that fit beside a picture
constexpr std::size_t kHalfTable = 72;   // bytes across that fit in half a slide
constexpr std::size_t kCell = 16;        // bytes: longer cells may be broken there
constexpr std::size_t kBetween = 2;      // the gap between two columns in bytes

bool hasWords(const Slide& slide, TableWidth tables) {
    return !slide.text.empty() || !slide.formulas.empty() || !slide.code.empty() ||
           tables != TableWidth::none;
}

/// The width of the table in bytes: the sum of each column's longest cell.
std::size_t across(const MadeTable& table) {
    std::size_t sum = 0;
    for (std::size_t column = 0; column < table.head.size(); ++column) {
        std::size_t most = table.head[column].size();
        for (const std::vector<std::string>& row : table.rows)
            most = std::max(most, row[column].size());
        sum += std::min(most, kCell) + kBetween;
    }
    return sum;
}

TableWidth widthOf(const MadeTable& table) {
    if (table.head.size() <= kNarrowTable) return TableWidth::narrow;
    return across(table) <= kHalfTable ? TableWidth::half : TableWidth::wide;
}

}  // namespace

TableWidth widthOf(const std::vector<MadeTable>& tables) {
    TableWidth width = TableWidth::none;
    for (const MadeTable& table : tables) width = std::max(width, widthOf(table));
    return width;
}

SlideLayout layoutOf(const Slide& slide, TableWidth tables, const std::vector<double>& aspects) {
    if (slide.opening) return aspects.empty() ? SlideLayout::opening : SlideLayout::openingPictured;
    if (aspects.empty()) return SlideLayout::plain;
    if (!hasWords(slide, tables)) return SlideLayout::full;
    if (aspects.size() == 1 && aspects.front() > kWide) return SlideLayout::below;
    if (tables == TableWidth::wide) return SlideLayout::below;
    if (tables == TableWidth::half) return SlideLayout::even;
    // Pictures above each other would be small.
    if (aspects.size() > 1 && slide.formulas.empty() && slide.code.empty() &&
        tables == TableWidth::none && slide.text.size() <= kLongText)
        return SlideLayout::below;
    const bool half = !slide.code.empty() || slide.text.size() > kLongText;
    return half ? SlideLayout::even : SlideLayout::beside;
}

SlideLayout layoutOf(const MadeSlide& made) {
    std::vector<double> aspects;
    for (const MadePicture* picture : picturesOf(made)) aspects.push_back(aspectOf(*picture));
    return layoutOf(made.slide, widthOf(made.tables), aspects);
}

SlideRoom pictureRoom(SlideLayout layout, TableWidth tables) {
    switch (layout) {
        case SlideLayout::openingPictured:
            return {570.0, 600.0};
        case SlideLayout::beside:
            return {700.0, 540.0};
        case SlideLayout::even:
            return {tables == TableWidth::half ? 490.0 : 564.0, 540.0};
        case SlideLayout::below:
            return {1168.0, tables == TableWidth::wide ? 240.0 : 390.0};
        case SlideLayout::opening:
        case SlideLayout::plain:
        case SlideLayout::full:
            break;
    }
    return {1168.0, 540.0};
}

}  // namespace demos
