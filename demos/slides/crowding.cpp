#include "demos/slides/crowding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/slides/markup.h"
#include "demos/slides/slide_arrangement.h"

namespace demos {
namespace {

/// Letters per line and lines at half the usual size, the smallest that page/fit.js sets.
struct Capacity {
    double letters = 0.0, lines = 0.0;
};

Capacity capacityOf(SlideLayout layout) {
    switch (layout) {
        case SlideLayout::beside:
            return {64.0, 31.0};
        case SlideLayout::even:
            return {84.0, 31.0};
        case SlideLayout::below:
            return {175.0, 28.0};
        case SlideLayout::full:
        case SlideLayout::plain:
        case SlideLayout::opening:
        case SlideLayout::openingPictured:
            break;
    }
    return {142.0, 24.0};
}

constexpr double kParagraphGap = 0.42;  // lines between two paragraphs
constexpr double kFormula = 1.8;        // lines per formula
constexpr double kCodeLine = 0.8;       // lines of text per line of code

/// Lines of HTML that cmark made: the text between tags, paragraph by paragraph.
double linesOf(const std::string& html, double across) {
    double lines = 0.0, letters = 0.0;
    for (std::size_t i = 0; i < html.size(); ++i) {
        if (html[i] != '<') {
            letters += (html[i] & 0xc0) != 0x80 ? 1.0 : 0.0;  // the first byte in UTF-8
            continue;
        }
        const std::size_t end = std::min(html.find('>', i), html.size() - 1);
        const std::string tag = html.substr(i, end - i + 1);
        i = end;
        if (tag != "</p>" && tag != "</li>" && !tag.starts_with("</h")) continue;
        if (letters > 1.0) lines += std::ceil(letters / across) + kParagraphGap;
        letters = 0.0;
    }
    return lines;
}

double linesOf(const Slide& slide, double across) {
    double lines = linesOf(htmlOf(slide.text), across);
    lines += kFormula * static_cast<double>(slide.formulas.size());
    if (!slide.code.empty())
        lines +=
            kCodeLine *
            (2.0 + static_cast<double>(std::count(slide.code.begin(), slide.code.end(), '\n')));
    return lines;
}

}  // namespace

std::string crowdingOf(const Deck& deck, const Slide& slide, std::size_t number) {
    const Capacity room = capacityOf(plannedLayout(slide));
    const double lines = linesOf(slide, room.letters);
    if (lines <= room.lines) return {};
    const int line = slide.place.line;
    const std::string where =
        line > 0 && !deck.files.empty() ? fmt::format("{}:{}: ", deck.files[0].string(), line) : "";
    return fmt::format(
        "{}slide {}, '{}': about {:.0f} lines of the smallest letters, but only {:.0f} fit; leave "
        "some out, or make two slides",
        where, number, plainOf(slide.title), lines, room.lines);
}

}  // namespace demos
