/// A formula, laid out: letters and strokes at their places. Lengths are in em of the text in which it
/// stands; x points right from its left end, y up from the baseline.
#pragma once
#include <vector>

namespace render {

/// A letter at its place.
struct FormulaLetter {
    int codepoint = 0;         // of Unicode
    float x = 0.0f, y = 0.0f;  // of its left end, on its baseline
    float size = 1.0f;         // relative to the letters of the text
    float stretch = 1.0f;      // times as tall, about the baseline: parentheses around fractions
    bool italic = false;       // from the italic font, if it has the letter
    bool bold = false;         // drawn twice
};

/// A line through all points: the bar of a fraction, a root's sign.
struct FormulaStroke {
    /// A point of the line.
    struct Corner {
        float x = 0.0f;  // to the right
        float y = 0.0f;  // up
    };
    std::vector<Corner> corners;
};

/// All letters and strokes of a formula, and the room that it needs.
struct Formula {
    float width = 0.0f;                   // to where the text goes on
    float ascent = 0.0f, descent = 0.0f;  // above and below the baseline
    std::vector<FormulaLetter> letters;   // drawn in this order
    std::vector<FormulaStroke> strokes;   // over the letters
};

constexpr float kFormulaStroke = 0.06f;  // width of a stroke

/// Formula k of a text stands in it as the character kFirstFormula + k, which fonts do not use.
constexpr int kFirstFormula = 0xf0000;
constexpr int kMostFormulas = 64;  ///< of a text

}  // namespace render
