// Formulas as lines of ordinary letters.
#include "demos/formulas/formula_runs.h"

#include <gtest/gtest.h>

#include "demos/formulas/formula.h"

namespace demos::test {
namespace {

/// Italic letters in slashes, bold ones in stars, raised and lowered ones after ^ and _.
std::string lineOf(const std::string& tex) {
    std::string line;
    for (const FormulaRun& run : formulaRuns(mathMlOf(tex, false))) {
        std::string text = run.text;
        if (run.bold) text = "*" + text + "*";
        if (run.italic) text = "/" + text + "/";
        line += (run.level > 0 ? "^" : run.level < 0 ? "_" : "") + text;
    }
    return line;
}

TEST(FormulaRuns, LettersKeepTheirLook) {
    EXPECT_EQ(lineOf("v"), "/v/");
    EXPECT_EQ(lineOf("\\mathbf J\\lambda"), "*J*/λ/");
    EXPECT_EQ(lineOf("\\boldsymbol\\omega"), "/*ω*/");
    EXPECT_EQ(lineOf("\\sin 2"), "sin 2");
    EXPECT_EQ(lineOf("\\Delta t"), "Δ/t/");
}

TEST(FormulaRuns, IndicesAreLoweredAndPowersRaised) {
    EXPECT_EQ(lineOf("m_a^{-1}"), "/m/_/a/^−1");
    EXPECT_EQ(lineOf("p_{a_b}"), "/p/_/a/___/b/");  // on the line of the first
    EXPECT_EQ(lineOf("\\bar{\\mathbf v}_r"), "*v\xcc\x84*_/r/");
}

TEST(FormulaRuns, OperatorsBetweenTermsHaveSpace) {
    EXPECT_EQ(lineOf("a=-b+c"), "/a/ = −/b/ + /c/");
    EXPECT_EQ(lineOf("\\lambda\\geq 0"), "/λ/ ≥ 0");
    EXPECT_EQ(lineOf("f(x,y)"), "/f/(/x/, /y/)");
}

TEST(FormulaRuns, FractionsAndRootsStandOnTheLine) {
    EXPECT_EQ(lineOf("\\frac{a}{b}"), "/a///b/");
    EXPECT_EQ(lineOf("\\frac{1}{2}m"), "1/2\xe2\x80\x89/m/");
    EXPECT_EQ(lineOf("\\frac{a+1}{\\Delta t}"), "(/a/ + 1)/Δ/t/");
    EXPECT_EQ(lineOf("\\sqrt{x}"), "√(/x/)");
    EXPECT_EQ(lineOf("\\sqrt[3]{x}"), "^3√(/x/)");
}

}  // namespace
}  // namespace demos::test
