// LaTeX to MathML: what is drawn, what is refused and where, what must not break anything.

#include "demos/slides/formula.h"

#include <gtest/gtest.h>

#include "demos/slides/math_letters.h"

namespace demos::test {
namespace {

const std::string kBegin = "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" ";

/// "3: Double superscript", or "" where it is taken.
std::string refused(const std::string& tex) {
    try {
        mathMlOf(tex, true);
    } catch (const FormulaError& error) {
        return std::to_string(error.at()) + ": " + error.what();
    }
    return "";
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

/// What is between <math ...> and </math>.
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

TEST(Formula, SaysWhatIsWrongAndAtWhichByte) {
    EXPECT_EQ(refused("x^2^3"), "3: Double superscript");
    EXPECT_EQ(refused("\\frca{a}{b}"), "0: Undefined control sequence: \\frca");
    EXPECT_EQ(refused("\\alpha \u03b2\u03b3 \\foo"), "12: Undefined control sequence: \\foo");
    EXPECT_EQ(refused("\\frac{a}{"),
              "9: Unexpected end of input in a macro argument, expected '}'");
    EXPECT_EQ(refused("a & b"), "2: Expected 'EOF', got '&'");
    EXPECT_EQ(refused("\\cancel{x}"),
              "0: browsers cannot draw a 'updiagonalstrike' around a term; leave it out, or use "
              "\\boxed");
}

TEST(Formula, LeadsNowhere) {
    EXPECT_EQ(refused("\\href{javascript:alert(1)}{x}"), "0: \\href is not allowed in a slide");
    EXPECT_EQ(refused("\\includegraphics{a.png}"),
              "0: \\includegraphics is not allowed in a slide");
    EXPECT_EQ(refused("\\htmlStyle{color: red}{x}"), "0: \\htmlStyle is not allowed in a slide");
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

// A macro of one formula is not known to the next.
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
