#include "render/formula_lines.h"

#include <algorithm>
#include <cmath>

#include "render/glyphs.h"

namespace render {
namespace {

float emPixels(int pixels) { return static_cast<float>(kEmShare) * static_cast<float>(pixels); }

/// Calls words(text) and formula(one) for the parts of a line, from left to right.
template <class Words, class OneFormula>
void forEachPart(const std::string& line, std::span<const Formula> formulas, const Words& words,
                 const OneFormula& formula) {
    // In UTF-8, kFirstFormula + k is F3 B0 80 80 + k.
    constexpr const char* kMark = "\xf3\xb0\x80";
    std::size_t from = 0;
    for (std::size_t at = line.find(kMark); at != std::string::npos && at + 3 < line.size();
         at = line.find(kMark, at + 4)) {
        const auto k = static_cast<std::size_t>(static_cast<unsigned char>(line[at + 3]) - 0x80);
        if (k >= formulas.size()) continue;
        words(line.substr(from, at - from));
        formula(formulas[k]);
        from = at + 4;
    }
    words(line.substr(from));
}

void drawFormula(Image& image, const Formula& formula, int pixels, Point at, const Color& color) {
    const float em = emPixels(pixels);
    const auto place = [&](float x, float y) { return Point{at.x + em * x, at.y - em * y}; };
    for (const FormulaLetter& letter : formula.letters)
        drawLetter(image, letter, static_cast<float>(pixels), place(letter.x, letter.y), color);
    for (const FormulaStroke& stroke : formula.strokes) {
        std::vector<Point> corners;
        for (const FormulaStroke::Corner& corner : stroke.corners)
            corners.push_back(place(corner.x, corner.y));
        drawPolyline(image, corners, std::max(kFormulaStroke * em, 1.0f), color);
    }
}

}  // namespace

float lineWidth(const std::string& line, std::span<const Formula> formulas, int pixels) {
    float width = 0.0f;
    forEachPart(
        line, formulas,
        [&](const std::string& words) { width += textWidth(words, static_cast<float>(pixels)); },
        [&](const Formula& formula) { width += emPixels(pixels) * formula.width; });
    return width;
}

LineReach lineReach(const std::string& line, std::span<const Formula> formulas, int pixels) {
    const float ascent = textAscent(pixels), descent = static_cast<float>(pixels) - ascent;
    LineReach reach;
    const auto widen = [&](const Formula& formula) {
        reach.above = std::max(reach.above, emPixels(pixels) * formula.ascent - ascent);
        reach.below = std::max(reach.below, emPixels(pixels) * formula.descent - descent);
    };
    forEachPart(line, formulas, [](const std::string&) {}, widen);
    return reach;
}

void drawFormulaLine(Image& image, const std::string& line, std::span<const Formula> formulas, int pixels,
                     Point at, const Color& color) {
    forEachPart(
        line, formulas,
        [&](const std::string& words) {
            drawLabel(image, words, at, Anchor::start, static_cast<float>(pixels), color);
            at.x += textWidth(words, static_cast<float>(pixels));
        },
        [&](const Formula& formula) {
            drawFormula(image, formula, pixels, at, color);
            at.x += emPixels(pixels) * formula.width;
        });
}

}  // namespace render
