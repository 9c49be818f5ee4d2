// LaTeX to MathML: what is drawn, what is refused and where, and hostile input.

#include "demos/formulas/formula.h"

#include <gtest/gtest.h>

#include "demos/formulas/math_letters.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

using support::repeated;

const std::string kBegin = "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" ";

/// "3: Double superscript", or "" if it is accepted.
std::string refused(const std::string& tex) {
    try {
        mathMlOf(tex, true);
    } catch (const FormulaError& error) {
        return std::to_string(error.at()) + ": " + error.what();
    }
    return "";
}

/// The content of <math ...>.
std::string inside(const std::string& tex) {
    const std::string math = mathMlOf(tex, false);
    const std::size_t begin = math.find("\"><") + 2;
    return math.substr(begin, math.rfind("</math>") - begin);
}

TEST(Formula, BecomesMathMlWithItsTextAsAltText) {
    EXPECT_EQ(mathMlOf("\\frac{a}{2}", false),
              kBegin +
                  "alttext=\"\\frac{a}{2}\"><mrow><mfrac><mi>a</mi><mn>2</mn></mfrac></mrow>"
                  "</math>");
    EXPECT_EQ(mathMlOf("a < \\text{\"b\"}", true),
              kBegin +
                  "display=\"block\" alttext=\"a &lt; \\text{&quot;b&quot;}\">"
                  "<mrow><mi>a</mi><mo>&lt;</mo><mtext>\"b\"</mtext></mrow></math>");
}

TEST(Formula, KeepsSpacesOfTexts) {
    EXPECT_EQ(inside("\\text{ a }"), "<mrow><mtext>\u00a0a\u00a0</mtext></mrow>");
}

// MathML Core has no mathvariant but "normal".
TEST(Formula, HasItsLettersFromUnicode) {
    EXPECT_EQ(inside("\\mathbf{v}"), "<mrow><mi>\U0001d42f</mi></mrow>");
    EXPECT_EQ(inside("\\mathbb{R}"), "<mrow><mi>\u211d</mi></mrow>");
    EXPECT_EQ(inside("\\boldsymbol{\\omega}"), "<mrow><mi>\U0001d74e</mi></mrow>");
    EXPECT_EQ(inside("\\mathrm{d}"), "<mrow><mi mathvariant=\"normal\">d</mi></mrow>");
    EXPECT_EQ(inside("\\textbf{ab}"), "<mrow><mtext style=\"font-weight:bold;\">ab</mtext></mrow>");
}

TEST(Formula, AlignsWhatKatexAligns) {
    EXPECT_EQ(inside("\\begin{aligned} a &= b \\end{aligned}"),
              "<mtable><mtr><mtd style=\"text-align:right;padding-right:0;\"><mstyle "
              "scriptlevel=\"0\" displaystyle=\"true\"><mi>a</mi></mstyle></mtd><mtd "
              "style=\"text-align:left;padding-left:0;\"><mstyle scriptlevel=\"0\" "
              "displaystyle=\"true\"><mrow><mrow/><mo>=</mo><mi>b</mi></mrow></mstyle></mtd></mtr>"
              "</mtable>");
}

TEST(Formula, DrawsBoxesRulesAndArrowsByItself) {
    EXPECT_EQ(inside("\\fbox{x}").find("menclose"), std::string::npos);
    EXPECT_NE(inside("\\boxed{x}").find("<mrow style=\"border:0.06em solid;"), std::string::npos);
    const std::string rules = inside("\\begin{array}{c|c} a & b \\\\ \\hline c & d \\end{array}");
    EXPECT_NE(rules.find("border-right:0.06em solid;border-bottom:0.06em solid;"),
              std::string::npos)
        << rules;
    EXPECT_EQ(inside("\\vec v"),
              "<mrow><mover accent=\"true\"><mi>v</mi><mo lspace=\"0\" rspace=\"0\" "
              "stretchy=\"false\">\u2192</mo></mover></mrow>");
}

/// Whether the MathML of `tex` has the text.
testing::AssertionResult has(const std::string& tex, const std::string& part) {
    const std::string math = inside(tex);
    if (math.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << tex << " has no " << part << ": " << math;
}

// KaTeX wraps them in <mo>, whose children browsers do not lay out.
TEST(Formula, StacksSignsAndNames) {
    EXPECT_EQ(inside("\\stackrel{!}{=}"),
              "<mrow><mover><mo>=</mo><mo stretchy=\"false\" lspace=\"0em\" "
              "rspace=\"0em\">!</mo></mover></mrow>");
    EXPECT_EQ(inside("\\overset{a}{=}"), "<mrow><mover><mo>=</mo><mi>a</mi></mover></mrow>");
    EXPECT_EQ(inside("\\underset{x}{a}"), "<mrow><munder><mi>a</mi><mi>x</mi></munder></mrow>");
    EXPECT_TRUE(has("\\underset{x}{\\min}", "<munder><mrow><mi>min</mi><mo>\u2061</mo></mrow>"));
}

TEST(Formula, HasOperatorsThatAreWords) {
    EXPECT_TRUE(has("a \\bmod b", "<mo lspace=\"0.22em\" rspace=\"0.22em\">mod</mo>"));
}

TEST(Formula, HasBarsThatStretch) {
    const std::string stretches =
        " stretchy=\"true\" symmetric=\"true\" lspace=\"0\" rspace=\"0\">";
    const std::string one = "<mo fence=\"true\"" + stretches + "|</mo>";
    const std::string two = "<mo fence=\"true\"" + stretches + "\u2016</mo>";
    EXPECT_EQ(inside("\\left| a \\right|"), "<mrow>" + one + "<mi>a</mi>" + one + "</mrow>");
    EXPECT_TRUE(has("\\left\\| a \\right\\|_2", two + "</mrow><mn>2</mn></msub>"));
    EXPECT_TRUE(has("\\left. a \\right|_0", "<mi>a</mi>" + one));
    EXPECT_TRUE(has("\\begin{vmatrix} a \\end{vmatrix}", "<mrow>" + one + "<mtable>"));
    EXPECT_TRUE(has("a \\mid b", "<mo>\u2223</mo>")) << "a relation, as high as a letter";
}

TEST(Formula, HasLinesAndAccentsAsWideAsTheirTerm) {
    EXPECT_TRUE(has("\\overline{ab}", "style=\"border-top:0.06em solid;padding-top:0.12em;\""));
    EXPECT_TRUE(has("\\underline{ab}", "style=\"border-bottom:0.06em solid;"));
    EXPECT_TRUE(has("\\widehat{ab}", "<mo stretchy=\"true\">\u0302</mo>"));
    EXPECT_TRUE(has("\\widetilde{abcde}", "style=\"transform:scaleX(4.0);\">~</mo>"));
    EXPECT_TRUE(has("\\hat a", "<mo>^</mo>"));
    EXPECT_TRUE(has("\\overrightarrow{ab}", "<mo stretchy=\"true\">\u2192</mo>"));
}

TEST(Formula, HasRoomAroundNamesOfFunctions) {
    const std::string room = "<mspace width=\"0.1667em\"/>";
    EXPECT_EQ(inside("2\\sin x"), "<mrow><mn>2</mn>" + room + "<mi>sin</mi><mo>\u2061</mo>" + room +
                                      "<mi>x</mi></mrow>");
    EXPECT_TRUE(has("\\sin^2 x", "</msup>" + room + "<mi>x</mi>"));
    EXPECT_TRUE(has("\\max_i x", "</msub>" + room + "<mi>x</mi>"));
    for (const char* tex : {"\\sin(x)", "(\\sin", "\\sin", "a - \\sin(x)", "\\det\\left(A\\right)"})
        EXPECT_EQ(inside(tex).find("mspace"), std::string::npos) << tex;
}

TEST(Formula, HasAMinusOfOneTermCloseToIt) {
    const std::string close = "<mo form=\"prefix\">\u2212</mo>";
    for (const char* tex :
         {"a = -b", "(-a)", "a, -b", "a \\times -b", "\\sum_i -b", "\\sin -b",
          "\\left| -a \\right|", "|a| = |-b|", "\\lvert -a \\rvert", "a = \\quad -b"})
        EXPECT_TRUE(has(tex, close));
    for (const char* tex :
         {"a - b", "(a) - b", "|a| - b", "|a|^2 - b", "\\lvert a \\rvert - b", "a! - b",
          "1 + \\ldots - n", "\\left| a \\right| - b", "x_i - b", "10^{-}"})
        EXPECT_EQ(inside(tex).find("prefix"), std::string::npos) << tex;
}

TEST(Formula, SaysWhatIsWrongAndAtWhichByte) {
    EXPECT_EQ(refused("x^2^3"), "3: Double superscript");
    EXPECT_EQ(refused("\\frca{a}{b}"), "0: Undefined control sequence: \\frca");
    EXPECT_EQ(refused("\\alpha \u03b2\u03b3 \\foo"), "12: Undefined control sequence: \\foo");
    EXPECT_EQ(refused("\\frac{a}{"),
              "9: Unexpected end of input in a macro argument, expected '}'");
    EXPECT_EQ(refused("a & b"), "2: Expected 'EOF', got '&'");
    EXPECT_EQ(refused("\\cancel{x}"),
              "0: 'updiagonalstrike' around a term is not supported; leave it out, or use "
              "\\boxed");
}

TEST(Formula, LeadsNowhere) {
    EXPECT_EQ(refused("\\href{javascript:alert(1)}{x}"), "0: \\href is not allowed in a formula");
    EXPECT_EQ(refused("\\includegraphics{a.png}"),
              "0: \\includegraphics is not allowed in a formula");
    EXPECT_EQ(refused("\\htmlStyle{color: red}{x}"), "0: \\htmlStyle is not allowed in a formula");
    EXPECT_EQ(inside("\\text{<script>}"), "<mrow><mtext>&lt;script&gt;</mtext></mrow>");
    EXPECT_EQ(mathMlOf("\\text{\"><b>}", false).find("<b>"), std::string::npos);
}

TEST(Formula, RefusesWhatGrowsWithoutEndAndGoesOn) {
    EXPECT_EQ(refused("\\def\\a{\\a\\a}\\a"),
              "0: Too many expansions: infinite loop or need to increase maxExpand setting");
    const std::string bomb = "\\def\\a{" + repeated("x", 900) + "}\\def\\b{" +
                             repeated("\\a", 400) + "}" + repeated("\\b", 10);
    EXPECT_EQ(refused(bomb), "0: the formula grows or nests too far; make it simpler");
    EXPECT_EQ(refused(repeated("x", 2001)),
              "0: the formula has 2001 bytes; it should have at most 2000");
    EXPECT_EQ(refused(repeated("\\sqrt{", 280) + "x" + repeated("}", 280)), "");
    EXPECT_EQ(refused(repeated("{", 900) + repeated("}", 900)), "");
    EXPECT_EQ(inside("x"), "<mrow><mi>x</mi></mrow>");
}

// A macro of one formula is not defined in the next.
TEST(Formula, ForgetsWhatItDefined) {
    EXPECT_EQ(refused("\\gdef\\mine{x}\\mine"), "");
    EXPECT_EQ(refused("\\mine"), "0: Undefined control sequence: \\mine");
}

TEST(Formula, RefusesWhatIsNoText) {
    EXPECT_EQ(refused(std::string("a\0b", 3)),
              "1: a control byte, or a byte that is not UTF-8; take it out");
    EXPECT_EQ(refused("ab\xff"), "2: a control byte, or a byte that is not UTF-8; take it out");
    EXPECT_EQ(refused("a\n+ b\t"), "");
}

TEST(MathLetters, FillTheHolesOfUnicode) {
    EXPECT_EQ(inVariant("Bb1", "script"), "\u212c\U0001d4b71");
    EXPECT_EQ(inVariant("hH", "italic"), "\u210e\U0001d43b");
    EXPECT_EQ(inVariant("Z9", "double-struck"), "\u2124\U0001d7e1");
    EXPECT_EQ(inVariant("\u03b1\u03a9+", "bold"), "\U0001d6c2\U0001d6c0+");
    EXPECT_EQ(inVariant("a", "no such"), "a");
}

}  // namespace
}  // namespace demos::test
