#include "demos/slides/slide_layout.h"

#include <algorithm>

#include "demos/slides/slide_media.h"

namespace demos {
namespace {

constexpr double kWide = 2.6;            // width over height: a strip
constexpr std::size_t kLongText = 360;   // bytes
constexpr std::size_t kNarrowTable = 4;  // columns that fit beside a picture

bool hasWords(const MadeSlide& made) {
    const Slide& slide = made.slide;
    return !slide.text.empty() || !slide.formulas.empty() || !slide.code.empty() ||
           !made.tables.empty();
}

bool hasWideTable(const MadeSlide& made) {
    return std::any_of(made.tables.begin(), made.tables.end(),
                       [](const MadeTable& table) { return table.head.size() > kNarrowTable; });
}

}  // namespace

SlideLayout layoutOf(const MadeSlide& made) {
    const std::vector<const MadePicture*> pictures = picturesOf(made);
    if (made.slide.opening)
        return pictures.empty() ? SlideLayout::opening : SlideLayout::openingPictured;
    if (pictures.empty()) return SlideLayout::plain;
    if (!hasWords(made)) return SlideLayout::full;
    if (pictures.size() == 1 && aspectOf(*pictures.front()) > kWide) return SlideLayout::below;
    if (hasWideTable(made)) return SlideLayout::below;
    // One above the other they would be small.
    if (pictures.size() > 1 && made.slide.formulas.empty() && made.slide.code.empty() &&
        made.tables.empty() && made.slide.text.size() <= kLongText)
        return SlideLayout::below;
    const bool half = !made.slide.code.empty() || made.slide.text.size() > kLongText;
    return half ? SlideLayout::even : SlideLayout::beside;
}

}  // namespace demos
