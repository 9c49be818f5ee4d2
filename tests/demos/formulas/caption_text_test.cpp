// Formulas in captions: what they look like in pictures and in ordinary letters.
#include "demos/formulas/caption_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "demos/formulas/formula.h"

namespace demos::test {
namespace {

std::string lettersOf(const std::string& tex) { return captionText("$" + tex + "$").letters; }

render::Formula formulaOf(const std::string& tex) { return captionText("${" + tex + "}$").formulas.at(0); }

const render::FormulaLetter& letterOf(const render::Formula& formula, int codepoint) {
    const auto found = std::find_if(formula.letters.begin(), formula.letters.end(),
                                    [&](const render::FormulaLetter& letter) { return letter.codepoint == codepoint; });
    if (found == formula.letters.end()) throw std::runtime_error("no such letter");
    return *found;
}

std::string errorOf(const std::string& text) {
    try {
        captionText(text);
    } catch (const FormulaError& error) {
        return std::to_string(error.at()) + ": " + error.what();
    }
    return "none";
}

TEST(CaptionText, KeepsWordsAndMarksFormulas) {
    const CaptionText text = captionText("at $v^2$ and $w$, \\$5 or $6");
    EXPECT_EQ(text.line, "at " + formulaMark(0) + " and " + formulaMark(1) + ", $5 or $6");
    EXPECT_EQ(text.letters, "at v² and w, $5 or $6");
    EXPECT_EQ(text.markup, (std::vector<std::string>{"$v^2$", "$w$"}));
    EXPECT_TRUE(captionText("400 kg, 5 $").formulas.empty());
}

TEST(CaptionText, LinesCanBreakBeforeRelations) {
    const CaptionText text = captionText("$a = b \\le {c = d}$ or $x$");
    EXPECT_EQ(text.line, formulaMark(0) + " " + formulaMark(1) + " " + formulaMark(2) + " or " + formulaMark(3));
    EXPECT_EQ(text.letters, "a = b ≤ c = d or x");
    EXPECT_EQ(text.markup, (std::vector<std::string>{"$a = b \\le {c = d}$", "", "", "$x$"}));
    EXPECT_EQ(text.formulas[1].letters.size(), 2u);
    EXPECT_EQ(text.formulas[2].letters.size(), 4u);
    EXPECT_EQ(text.formulas[1].letters[0].x, 0.0f);
    EXPECT_EQ(captionText("$= 3$").formulas.size(), 1u);
}

TEST(CaptionText, HasOrdinaryLettersAsFarAsUnicodeHasThem) {
    EXPECT_EQ(lettersOf("\\omega^2 \\sin\\alpha_{12}"), "ω² sin α₁₂");
    EXPECT_EQ(lettersOf("v_n^{-1}"), "vₙ⁻¹");
    EXPECT_EQ(lettersOf("x^{a+b} y^{kq}"), "xᵃ⁺ᵇy^(kq)");
    EXPECT_EQ(lettersOf("\\frac{g\\sin 8^\\circ}{1+k}"), "(g sin 8°)/(1 + k)");
    EXPECT_EQ(lettersOf("\\frac{\\frac ab}c"), "(a/b\u2009)/c");
    EXPECT_EQ(lettersOf("\\frac{a}{\\dfrac{b}{c}}"), "a/(b/c)");
    EXPECT_EQ(lettersOf("2^{2^n}"), "2^(2^n)");
    EXPECT_EQ(lettersOf("e^{-x^2}"), "e^(−x^2)");
    EXPECT_EQ(lettersOf("a_{n_1}"), "a_(n_1)");
    EXPECT_EQ(lettersOf("x_{n+1}"), "xₙ₊₁");
    EXPECT_EQ(lettersOf("\\binom{n}{k}"), "(n over k)");
    EXPECT_EQ(lettersOf("\\phantom{x}y"), "y");
}

TEST(CaptionText, ScriptsAreSmallerAndRaisedOrLowered) {
    const render::Formula formula = formulaOf("x_i^2");
    const auto &base = letterOf(formula, 'x'), &lower = letterOf(formula, 'i'), &upper = letterOf(formula, '2');
    EXPECT_TRUE(base.italic && lower.italic && !upper.italic);
    EXPECT_EQ(base.y, 0.0f);
    EXPECT_GT(upper.y, 0.2f);
    EXPECT_LT(lower.y, -0.1f);
    EXPECT_LT(upper.size, 0.9f);
    EXPECT_GT(upper.x, base.x);
    EXPECT_EQ(letterOf(formulaOf("x^{2^3}"), '3').size, letterOf(formulaOf("x^{y^{2^3}}"), '3').size);
}

TEST(CaptionText, FractionsStandAboveEachOtherWithABar) {
    const render::Formula formula = formulaOf("\\frac{a}{bcd}");
    ASSERT_EQ(formula.strokes.size(), 1u);
    const float bar = formula.strokes[0].corners[0].y;
    const auto &above = letterOf(formula, 'a'), &below = letterOf(formula, 'c');
    EXPECT_GT(above.y, bar);
    EXPECT_LT(below.y, bar - 0.3f);
    EXPECT_NEAR(above.x, below.x, 0.1f);  // above the middle
    EXPECT_GT(formula.ascent, above.y + 0.3f);
    EXPECT_GT(formula.descent, -below.y);
    EXPECT_TRUE(formulaOf("\\binom ab").strokes.empty());
    EXPECT_LT(formula.ascent, formulaOf("\\displaystyle\\frac{a}{bcd}").ascent);
    EXPECT_EQ(letterOf(captionText("$$\\frac{a}{b}$$").formulas.at(0), 'a').size, 1.0f);
}

TEST(CaptionText, RootsAndFencesReachAroundWhatTheyHold) {
    const render::Formula low = formulaOf("\\sqrt{x}"), high = formulaOf("\\sqrt{\\frac{a}{b}}");
    EXPECT_GT(high.ascent, low.ascent + 0.1f);
    EXPECT_EQ(formulaOf("(x)").letters.front().stretch, 1.0f);
    const render::Formula tall = formulaOf("\\left(\\frac{a}{b}\\right)");
    EXPECT_GT(tall.letters.front().stretch, 1.2f);
    EXPECT_GT(tall.ascent, formulaOf("(x)").ascent);
    const render::Formula cases = formulaOf("\\begin{cases}0&x<0\\\\1&x\\ge 0\\end{cases}");
    EXPECT_GT(letterOf(cases, '0').y, letterOf(cases, '1').y + 0.8f);
}

TEST(CaptionText, OperatorsHaveSpaceBetweenTermsOnly) {
    const float digits = formulaOf("12").width, sign = formulaOf("+").width;
    EXPECT_GT(formulaOf("1+2").width, digits + sign + 0.3f);
    EXPECT_NEAR(formulaOf("+12").width, digits + sign, 1e-4f);
    EXPECT_NEAR(formulaOf("x^{1+2}").width - formulaOf("x^{12}").width, 0.76f * sign, 1e-4f);
}

TEST(CaptionText, SignsHaveTheSpaceOfTheirKind) {
    const float plus = formulaOf("+").width, terms = formulaOf("ab").width;
    EXPECT_GT(formulaOf("\\dots+b").width, formulaOf("\\dots b").width + plus + 0.3f);
    EXPECT_GT(formulaOf("|a|+b").width, formulaOf("|a|b").width + plus + 0.3f);
    EXPECT_EQ(captionText("$a\\simeq b$").formulas.size(), 2u);
    EXPECT_EQ(captionText("$a\\overset{!}{=}b$").formulas.size(), 2u);
    EXPECT_LT(formulaOf("a\\!b").width, terms);
    EXPECT_EQ(captionText("$a := b$").formulas.size(), 2u);
    const render::Formula defined = captionText("$a := b$").formulas[1];
    EXPECT_LT(letterOf(defined, '=').x - letterOf(defined, ':').x, 0.4f);
    EXPECT_NEAR(formulaOf("a\\vphantom{x}b").width, terms, 1e-4f);
}

TEST(CaptionText, SumsAndBracketsHaveTheirSize) {
    const auto sizeOf = [](const std::string& tex, int codepoint) { return letterOf(formulaOf(tex), codepoint).size; };
    EXPECT_GT(sizeOf("\\int F", 0x222b), 1.1f);
    EXPECT_EQ(sizeOf("\\int F", 0x222b), sizeOf("\\int_0^1 F", 0x222b));
    EXPECT_GT(letterOf(captionText("$$\\sum F$$").formulas[0], 0x2211).size, 1.5f);
    EXPECT_GT(letterOf(formulaOf("\\Big(x\\Big)"), '(').stretch, 1.5f);
}

TEST(CaptionText, TablesHaveTheirColumns) {
    const render::Formula apart = formulaOf("\\begin{matrix}a&b\\end{matrix}");
    const render::Formula joined = formulaOf("\\begin{aligned}a&=b\\end{aligned}");
    EXPECT_GT(letterOf(apart, 'b').x, letterOf(apart, 'a').x + 1.0f);
    EXPECT_LT(letterOf(joined, '=').x, letterOf(joined, 'a').x + 1.0f);
    EXPECT_EQ(formulaOf("\\begin{array}{c|c}a&b\\end{array}").strokes.size(), 1u);
}

TEST(CaptionText, DegreesAndPrimesAreTheSignsOfTheFont) {
    EXPECT_EQ(letterOf(formulaOf("30^\\circ"), 0xb0).y, 0.0f);
    EXPECT_EQ(letterOf(formulaOf("v'"), 0x2032).size, 1.0f);
    EXPECT_LT(letterOf(formulaOf("v_n'"), 'n').y, 0.0f);
    EXPECT_EQ(letterOf(formulaOf("f''"), 0x2032).size, 1.0f);
    EXPECT_GT(letterOf(formulaOf("\\left(\\frac{a}{b}\\right)'"), 0x2032).y, 0.1f);
}

TEST(CaptionText, BoldAccentsLimitsAndBoxes) {
    const render::Formula bold = formulaOf("\\dot{\\mathbf v}");
    EXPECT_TRUE(letterOf(bold, 'v').bold);
    EXPECT_GT(letterOf(bold, 0x2d9).y, 0.0f);
    const render::Formula sum = formulaOf("\\displaystyle\\sum_{i}^{n}");
    EXPECT_GT(letterOf(sum, 'n').y, 0.7f);
    EXPECT_LT(letterOf(sum, 'i').y, -0.5f);
    EXPECT_EQ(formulaOf("\\boxed{x}").strokes.size(), 4u);
    EXPECT_TRUE(formulaOf("\\phantom{x}").letters.empty());
}

TEST(CaptionText, BadFormulasAreReportedWithTheirByte) {
    EXPECT_EQ(errorOf("at $\\frac{a}$"), "12: Unexpected end of input in a macro argument, expected '}'");
    EXPECT_NE(errorOf("$\theta$").find("1: a tab, a line break or a control byte; write LaTeX on one line in single"),
              std::string::npos);
    EXPECT_NE(errorOf("$a\theta$").find("2: a tab"), std::string::npos);
    EXPECT_NE(errorOf("at $\\mathfrak{A}$").find("4: the fonts of pictures lack the letter"), std::string::npos);
    std::string many;
    for (int i = 0; i < 65; ++i) many += "$x$ ";
    EXPECT_NE(errorOf(many).find("more than 64 formulas and relations"), std::string::npos);
    EXPECT_NE(errorOf("$" + std::string(600, 'x') + "$").find("the formula has 600 letters"), std::string::npos);
}

}  // namespace
}  // namespace demos::test
