#include "demos/formulas/formula_boxes.h"

#include <algorithm>

#include "render/glyphs.h"

namespace demos {
namespace {

constexpr float kStroke = render::kFormulaStroke;

float height(const Formula& box) { return box.ascent + box.descent; }
bool isEmpty(const Formula& box) { return box.letters.empty() && box.strokes.empty(); }

void putCentred(const Formula& part, float y, Formula& box) { put(part, 0.5f * (box.width - part.width), y, box); }

void stroke(const std::vector<render::FormulaStroke::Corner>& corners, Formula& box) {
    box.strokes.push_back({corners});
    for (const auto& [x, y] : corners) {
        box.ascent = std::max(box.ascent, y + 0.5f * kStroke);
        box.descent = std::max(box.descent, 0.5f * kStroke - y);
    }
}

}  // namespace

void put(const Formula& part, float x, float y, Formula& box) {
    for (render::FormulaLetter letter : part.letters) {
        letter.x += x, letter.y += y;
        box.letters.push_back(letter);
    }
    for (render::FormulaStroke line : part.strokes) {
        for (auto& corner : line.corners) corner.x += x, corner.y += y;
        box.strokes.push_back(line);
    }
    box.ascent = std::max(box.ascent, part.ascent + y);
    box.descent = std::max(box.descent, part.descent - y);
}

void append(const Formula& part, Formula& row) {
    put(part, row.width, 0.0f, row);
    row.width += part.width;
}

Formula space(float width) {
    Formula box;
    box.width = width;
    return box;
}

Formula letterBox(int codepoint, const LetterStyle& style) {
    const render::LetterExtent extent = render::letterExtent(codepoint, style.italic);
    Formula box;
    box.width = style.size * std::max(extent.advance, extent.right);  // an f leans over its advance
    box.ascent = style.size * std::max(extent.top, 0.0f);
    box.descent = style.size * std::max(-extent.bottom, 0.0f);
    box.letters.push_back({codepoint, 0.0f, 0.0f, style.size, 1.0f, style.italic, style.bold});
    return box;
}

float mathAxis(float size) {
    const render::LetterExtent minus = render::letterExtent(0x2212, false);
    return size * 0.5f * (minus.bottom + minus.top);
}

Formula fenceBox(int codepoint, const Formula& between, float size) {
    Formula box = letterBox(codepoint, {size});
    const float axis = mathAxis(size), middle = 0.5f * (box.ascent - box.descent);
    const float half = std::max(between.ascent - axis, between.descent + axis);
    const float stretch = std::max(2.0f * half / std::max(height(box), 0.1f), 1.0f);
    if (stretch < 1.15f) return box;
    render::FormulaLetter& letter = box.letters.front();
    letter.stretch = stretch;
    letter.y = axis - stretch * middle;
    box.ascent = stretch * box.ascent + letter.y;
    box.descent = stretch * box.descent - letter.y;
    return box;
}

Formula fractionBox(const Formula& above, const Formula& below, float size, bool bar) {
    const float gap = 0.1f * size + 0.5f * kStroke, side = 0.08f * size, axis = mathAxis(size);
    Formula box = space(std::max(above.width, below.width) + 2.0f * side);
    putCentred(above, axis + gap + above.descent, box);
    putCentred(below, axis - gap - below.ascent, box);
    if (bar) stroke({{0.5f * side, axis}, {box.width - 0.5f * side, axis}}, box);
    return box;
}

Formula rootBox(const Formula& inside, const Formula& degree, float size) {
    const float top = std::max(inside.ascent, 0.7f * size) + 0.12f * size;
    const float bottom = -inside.descent - 0.04f * size, sign = 0.55f * size;
    const float before = isEmpty(degree) ? 0.0f : std::max(degree.width - 0.25f * size, 0.0f);
    Formula box = space(before + sign + inside.width + 0.08f * size);
    put(inside, before + sign + 0.04f * size, 0.0f, box);
    const float knee = bottom + 0.55f * (top - bottom);
    if (!isEmpty(degree)) put(degree, 0.0f, knee + 0.12f * size, box);
    stroke({{before, knee - 0.04f * size},
            {before + 0.28f * sign, knee},
            {before + 0.55f * sign, bottom},
            {before + sign, top},
            {box.width, top}},
           box);
    return box;
}

Formula scriptsBox(const Formula& base, const Formula& lower, const Formula& upper, float size) {
    constexpr float kAfter = 0.05f;  // of the size: before the next term
    Formula box;
    append(base, box);
    float up = std::max(0.38f * size, base.ascent - 0.42f * size);
    float down = std::max(0.16f * size, base.descent + 0.02f * size);
    if (!isEmpty(lower) && !isEmpty(upper)) {
        const float between = up - upper.descent - (lower.ascent - down), least = 0.08f * size;
        if (between < least) down += 0.5f * (least - between), up += 0.5f * (least - between);
    }
    if (!isEmpty(upper)) put(upper, base.width, up, box);
    if (!isEmpty(lower)) put(lower, base.width, -down, box);
    box.width += std::max(upper.width, lower.width) + kAfter * size;
    return box;
}

Formula limitsBox(const Formula& base, const Formula& under, const Formula& over, float size) {
    const float gap = 0.12f * size;
    Formula box = space(std::max({base.width, under.width, over.width}));
    putCentred(base, 0.0f, box);
    if (!isEmpty(over)) putCentred(over, base.ascent + gap + over.descent, box);
    if (!isEmpty(under)) putCentred(under, -base.descent - gap - under.ascent, box);
    return box;
}

Formula accentBox(const Formula& base, int sign, float size) {
    Formula box;
    append(base, box);
    constexpr int kArrow = 0x2192;
    if (sign == kArrow) size *= 0.65f;  // as wide as a letter
    const render::LetterExtent extent = render::letterExtent(sign, false);
    Formula accent = letterBox(sign, {size});
    // From the sign's ink, wherever it is in the font; italic letters lean to the right.
    const bool leans = !base.letters.empty() && base.letters.front().italic;
    const float middle = 0.5f * (base.width + (leans ? 0.12f * size : 0.0f));
    const float above = std::max(base.ascent, 0.5f * size) + 0.1f * size - size * extent.bottom;
    accent.ascent = std::max(size * extent.top, 0.0f), accent.descent = 0.0f;
    put(accent, middle - 0.5f * size * (extent.left + extent.right), above, box);
    return box;
}

Formula linedBox(const Formula& inside, const Sides& sides, float size) {
    const float gap = 0.1f * size + 0.5f * kStroke;
    const float before = sides.left ? 2.0f * gap : 0.0f, after = sides.right ? 2.0f * gap : 0.0f;
    Formula box = space(before + inside.width + after);
    put(inside, before, 0.0f, box);
    const float left = 0.5f * kStroke, right = box.width - left;
    const float top = inside.ascent + gap, bottom = -inside.descent - gap;
    if (sides.top) stroke({{left, top}, {right, top}}, box);
    if (sides.bottom) stroke({{left, bottom}, {right, bottom}}, box);
    if (sides.left) stroke({{left, top}, {left, bottom}}, box);
    if (sides.right) stroke({{right, top}, {right, bottom}}, box);
    return box;
}

Formula tableBox(const std::vector<std::vector<Formula>>& rows, const std::vector<Column>& columns, float size) {
    const float gap = 0.8f * size, lead = 0.25f * size;
    std::vector<float> lefts, widths(columns.size());
    for (const std::vector<Formula>& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].width);
    Formula stack;  // from the baseline of the first row down
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (i > 0 && !columns[i].joined) stack.width += gap;
        lefts.push_back(stack.width);
        stack.width += widths[i];
    }
    float y = 0.0f;
    for (const std::vector<Formula>& row : rows) {
        float ascent = 0.7f * size, descent = 0.2f * size;
        for (const Formula& cell : row)
            ascent = std::max(ascent, cell.ascent), descent = std::max(descent, cell.descent);
        if (&row != &rows.front()) y -= ascent + lead;
        for (std::size_t i = 0; i < row.size(); ++i)
            put(row[i], lefts[i] + columns[i].side * (widths[i] - row[i].width), y, stack);
        y -= descent;
    }
    const float top = stack.ascent, bottom = -stack.descent;
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        if (columns[i].lineAfter) {
            const float x = 0.5f * (lefts[i] + widths[i] + lefts[i + 1]);
            stroke({{x, top}, {x, bottom}}, stack);
        }
    Formula box = space(stack.width);
    put(stack, 0.0f, mathAxis(size) + 0.5f * (stack.descent - stack.ascent), box);
    return box;
}

}  // namespace demos
