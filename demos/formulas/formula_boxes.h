/// The parts of a formula's layout as boxes: letters, fractions, roots, scripts, fences, tables. Lengths are in
/// em of the text; `size`: of the letters, 1 as in the text.
/// Source: D. E. Knuth, The TeXbook, appendix G, with few of its parameters.
#pragma once
#include <vector>

#include "render/formula.h"

namespace demos {

using render::Formula;

/// Copies a part into a box, at this place; the box does not get wider.
void put(const Formula& part, float x, float y, Formula& box);
/// Adds a part at the right end of a row.
void append(const Formula& part, Formula& row);
Formula space(float width);

struct LetterStyle {
    float size = 1.0f;
    bool italic = false, bold = false;
};
Formula letterBox(int codepoint, const LetterStyle& style);
/// A fence as tall as the row between it and its partner, about the row's middle line.
Formula fenceBox(int codepoint, const Formula& between, float size);

/// The height of a minus sign, about which fractions and fences are centred.
float mathAxis(float size);

Formula fractionBox(const Formula& above, const Formula& below, float size, bool bar);
Formula rootBox(const Formula& inside, const Formula& degree, float size);
/// Either script may be empty.
Formula scriptsBox(const Formula& base, const Formula& lower, const Formula& upper, float size);
/// The limits of a sum; either may be empty.
Formula limitsBox(const Formula& base, const Formula& under, const Formula& over, float size);
/// A sign right above a term, as a dot or an arrow.
Formula accentBox(const Formula& base, int sign, float size);
/// Lines along the sides of a term.
struct Sides {
    bool top = false, bottom = false, left = false, right = false;
};
Formula linedBox(const Formula& inside, const Sides& sides, float size);

/// A column of a table.
struct Column {
    float side = 0.5f;        // where narrower cells stand: 0 left, 1 right
    bool joined = false;      // no space before it
    bool lineAfter = false;
};
Formula tableBox(const std::vector<std::vector<Formula>>& rows, const std::vector<Column>& columns, float size);

}  // namespace demos
