// CommonMark with formulas as HTML, as LaTeX and as a plain line.

#include "demos/slides/markup.h"

#include <gtest/gtest.h>

#include <fstream>

#include "demos/formulas/formula.h"
#include "demos/formulas/text_formulas.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

using support::repeated;

const std::string kX =
    "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" "
    "alttext=\"x\"><mrow><mi>x</mi></mrow></math>";

std::vector<std::string> formulas(const std::string& text) {
    std::vector<std::string> all;
    for (const TextFormula& formula : formulasIn(text))
        all.push_back((formula.display ? "$$" : "$") + formula.tex);
    return all;
}

using List = std::vector<std::string>;

TEST(TextFormulas, AreBetweenDollars) {
    EXPECT_EQ(formulas("a $x$ b $$y\n+ z$$ c"), (List{"$x", "$$y\n+ z"}));
    EXPECT_EQ(formulas("$a \\$ b$"), (List{"$a \\$ b"}));
    EXPECT_EQ(formulasIn("ab $x$")[0].begin, 3u);
    EXPECT_EQ(formulasIn("ab $x$")[0].at, 4u);
    EXPECT_EQ(formulasIn("ab $x$")[0].end, 6u);
}

TEST(TextFormulas, ArePricesCodeOrNothingOtherwise) {
    for (const char* text : {"$5 and $6", "$ x$", "$x $", "\\$x$", "`$x$`", "``$x`$y$``", "$x$5",
                             "$$a\n\nb$$", "$", "$$", "$$$$", "a$", "```\n$x$\n```", "$a\n\nb$"})
        EXPECT_EQ(formulas(text), List{}) << text;
    EXPECT_EQ(formulas("` $x$"), (List{"$x"})) << "nothing closes the backquote";
}

TEST(TextFormulas, ReportsWhichDollarsAreOfNothing) {
    EXPECT_EQ(scannedText("$x $ `$` $5 \\$ $y$ $$").loose, (std::vector<std::size_t>{0, 3, 19}));
    EXPECT_EQ(scannedText("a `$` b").code.front().begin, 2u);
    EXPECT_EQ(scannedText("a `$` b").code.front().end, 5u);
}

TEST(Markup, IsHtml) {
    EXPECT_EQ(htmlOf("Some *words* and **more**,\n- a\n- `b`\n"),
              "<p>Some <em>words</em> and <strong>more</strong>,</p>\n<ul>\n<li>a</li>\n"
              "<li><code>b</code></li>\n</ul>\n");
    EXPECT_EQ(htmlOf("*$x$* \\$1 `$x$`"), "<p><em>" + kX + "</em> $1 <code>$x$</code></p>\n");
    EXPECT_NE(htmlOf("$$\nx\n- y\n$$").find("display=\"block\""), std::string::npos);
    EXPECT_EQ(htmlOf(""), "");
}

TEST(Markup, LeavesPunctuationAtItsFormula) {
    const std::string before = "<span class=\"kept\">";
    EXPECT_EQ(htmlOf("$x$, ($x$): $x$ a ($x$ $x$"),
              "<p>" + before + kX + ",</span> " + before + "(" + kX + "):</span> " + kX + " a " +
                  before + "(" + kX + "</span> " + kX + "</p>\n");
    EXPECT_EQ(htmlOf("$$x$$.").find("kept"), std::string::npos);
}

TEST(Markup, ShowsRawHtmlAsText) {
    EXPECT_EQ(htmlOf("a <b onclick='x'>c</b>"), "<p>a &lt;b onclick='x'&gt;c&lt;/b&gt;</p>\n");
    EXPECT_EQ(htmlOf("<script>\nalert($x$)\n</script>\n"),
              "<p>&lt;script&gt;\nalert($x$)\n&lt;/script&gt;</p>\n");
    EXPECT_EQ(htmlOf("&lt;b&gt; <!-- c -->"), "<p>&lt;b&gt; &lt;!-- c --&gt;</p>\n");
}

TEST(Markup, LinksToTheWebOnly) {
    EXPECT_EQ(htmlOf("[a](https://b.c/?d=$x$ 'e') [f](mailto:g@h.i)"),
              "<p><a href=\"https://b.c/?d=$x$\">a</a> <a href=\"mailto:g@h.i\">f</a></p>\n");
    for (const char* url :
         {"javascript:alert(1)", "JavaScript:x", "data:text/html,x", "file:///etc", "//b.c",
          "a.html", "#a", "ftp://b.c", "&#106;avascript:x"})
        EXPECT_EQ(htmlOf("[*a*](" + std::string(url) + ")"), "<p><em>a</em></p>\n") << url;
    EXPECT_EQ(htmlOf("![a *b*](https://c.d/e.png)"), "<p>a <em>b</em></p>\n");
}

TEST(Markup, HasTypographicQuotesAndDashesExceptInCode) {
    EXPECT_EQ(htmlOf("\"It's\" 'so' -- 1...2 `\"a\" -- b`"),
              "<p>\u201cIt\u2019s\u201d \u2018so\u2019 \u2013 1\u20262 "
              "<code>&quot;a&quot; -- b</code></p>\n");
    EXPECT_EQ(htmlOf(commonMarkOf("--set a-b, 1...2")), "<p>--set a-b, 1...2</p>\n")
        << "plain text is as it is written";
}

TEST(Markup, IsALineInATitle) {
    EXPECT_EQ(htmlInlineOf("1. Clamp _the_ $x$"), "1. Clamp <em>the</em> " + kX);
    EXPECT_EQ(htmlInlineOf("**\"a\"** b"), "<strong>\u201ca\u201d</strong> b");
    EXPECT_EQ(htmlInlineOf("_a_"), "<em>a</em>");
    EXPECT_EQ(htmlInlineOf("# a\n\n- b"), "# a  - b");
    EXPECT_EQ(htmlInlineOf("    a"), "a");
    EXPECT_EQ(htmlInlineOf("[a]: b"), "[a]: b");
    EXPECT_EQ(htmlInlineOf("$$x$$"), kX);
    EXPECT_EQ(htmlInlineOf(""), "");
    EXPECT_EQ(latexInlineOf("- 5 % of $x$"), "- 5 \\% of $x$");
}

TEST(Markup, IsAPlainLine) {
    EXPECT_EQ(plainOf("# The *total*\n\nis `>= 0`: $\\lambda$\n- a\n- [b](http://c.d)"),
              "The total is >= 0: \\lambda a b");
    EXPECT_EQ(plainOf(""), "");
}

TEST(Markup, IsATitleInLettersWhereFormulasAreALine) {
    EXPECT_EQ(titleTextOf("why $\\lambda \\ge 0$"), "why λ≥0");
    EXPECT_EQ(titleTextOf("$a < b > c$ & *d*"), "a<b>c & d");
    EXPECT_EQ(titleTextOf("$\\frac{a}{b}$ and $x^2$"), "\\frac{a}{b} and x^2");
}

TEST(Markup, IsMarkdownForMarp) {
    EXPECT_EQ(markdownOf("Some *words*,\nmore | ~~a~~ \\$1 $x_1$ `a|b`"),
              "Some *words*, more \\| \\~\\~a\\~\\~ \\$1 $x_1$ `a|b`");
    EXPECT_EQ(markdownOf("a $$x\n+ y$$ b"), "a \n$$x\n+ y$$\n b");
    EXPECT_EQ(markdownOf("$$x$$"), "$$x$$");
    EXPECT_EQ(markdownOf("a\n\n---\n\nb"), "a\n\nb");
    EXPECT_EQ(markdownInlineOf("- a <b>"), "\\- a \\<b\\>");
    EXPECT_EQ(markdownEscaped("24. 12. $"), "24\\. 12. \\$");
    for (const char* text : {"", "- a\n- b\n\n      c", "> a\n> $$x$$\n\n```\n<b> $\n---\n```"})
        EXPECT_EQ(htmlOf(markdownOf(text)), htmlOf(text)) << text;
}

TEST(Markup, ReportsTheByteOfAWrongFormula) {
    for (const auto& make : {htmlOf, htmlInlineOf, latexOf, latexInlineOf}) try {
            make("a *b* $x$ and $y^1^2$");
            ADD_FAILURE() << "taken";
        } catch (const FormulaError& error) {
            EXPECT_EQ(error.at(), 18u);
            EXPECT_STREQ(error.what(), "Double superscript");
        }
}

TEST(Markup, IsLatex) {
    EXPECT_EQ(latexOf("# Head\n\n50 % & *a_b* $x_1$\n\n---\n"),
              "\\textbf{Head}\n\n50 \\% \\& \\emph{a\\_b} $x_1$\n\n"
              "\\begin{center}\\rule{0.5\\linewidth}{0.4pt}\\end{center}\n");
    EXPECT_EQ(latexOf("$$a = b$$"), "\\[a = b\\]\n");
    EXPECT_EQ(latexOf("$$\\begin{align*} a \\end{align*}$$"), "\\begin{align*} a \\end{align*}\n");
    EXPECT_EQ(latexOf("$a % b$"), "$a % b\n$\n");
    EXPECT_EQ(latexOf("```\n\\end{verbatim} $x$\n\n  [y]\n```\n"),
              "\\begin{flushleft}\\ttfamily\n"
              "\\mbox{}\\textbackslash{}end\\{verbatim\\}~\\$x\\$\\\\\n\\mbox{}\\\\\n"
              "\\mbox{}~~{[}y{]}\n\\end{flushleft}\n");
    EXPECT_EQ(latexEscaped("a_b\\{}^~$#%&"),
              "a\\_b\\textbackslash{}\\{\\}\\^{}\\textasciitilde{}\\$\\#\\%\\&");
    EXPECT_EQ(latexFormulaOf("a\n\n\n= b", true), "\\[a\n= b\\]");
}

/// In Beamer lists nest at most three deep, quotes and lists together six deep.
TEST(Markup, IsFlatEnoughForBeamer) {
    const std::string latex = latexOf("- a\n  - b\n    - c\n      - d\n        - e\n\n> > > > f\n");
    EXPECT_EQ(latex.find("\\item d"), std::string::npos) << latex;
    for (const char* word : {"d\n", "e\n", "f\n"})
        EXPECT_NE(latex.find(word), std::string::npos) << latex;
    const auto count = [&](const std::string& what) {
        int n = 0;
        for (std::size_t i = 0; (i = latex.find(what, i)) != std::string::npos; ++i) ++n;
        return n;
    };
    EXPECT_EQ(count("\\begin{itemize}"), 3);
    EXPECT_EQ(count("\\begin{quote}"), 2);
}

TEST(Markup, IsTakenByLatex) {
    if (std::system("command -v pdflatex >/dev/null && kpsewhich beamer.cls >/dev/null") != 0)
        GTEST_SKIP() << "skipped: pdflatex or beamer is not installed";
    const support::TemporaryFolder folder;
    const std::string text =
        "# A *head* $\\lambda$\n\n\"a\" 'b' 5 % & #1 a_b ~ ^ \\\\ {} <c> | $a % b$ "
        "[d](https://e.f/%20_#~)\n"
        "\n$$\\begin{align} a &= b \\end{align}$$\n```\n\\end{verbatim}\n\n  [x]  -- y\n```\n"
        "- a\n  1. b\n     - c\n       - d\n\n> e\n> > f\n> > > g\n\n***\n";
    std::ofstream(folder / "a.tex") << "\\documentclass{beamer}\\usepackage[T1]{fontenc}\n"
                                       "\\begin{document}\\begin{frame}{"
                                    << latexInlineOf("1. _a_ $x$ `b_` 5 %") << "}\n"
                                    << latexOf(text) << latexCodeOf("if (a < b)\n    ++c;  // d")
                                    << "\n\\end{frame}\\end{document}\n";
    const std::string command = "cd '" + (folder / ".").string() +
                                "' && pdflatex -draftmode -halt-on-error -interaction=nonstopmode "
                                "a.tex >a.txt 2>&1 </dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(Markup, SurvivesAnything) {
    for (const std::string& text :
         {repeated("word $x *", 1 << 17), repeated("> ", 5000) + "a", repeated("- ", 3000) + "a",
          repeated("*", 50000), repeated("[", 20000) + "a" + repeated("](b)", 20000),
          repeated("`", 50000), repeated("$$ ", 3001), std::string("a\0b", 3),
          std::string("\xff\xfe\xc3($x$\xe0"), repeated("<", 50000),
          std::string("&#xE000;7&#xE001; \xee\x80\x80"), repeated("\\", 50001),
          repeated("\xee\x80\x80", 1000)}) {
        EXPECT_NO_THROW({
            htmlInlineOf(text);
            htmlOf(text);
            plainOf(text);
        }) << text.substr(0, 20);
        EXPECT_NO_THROW(latexOf(text)) << text.substr(0, 20);
    }
}

// The letters that mark formulas while cmark reads have no meaning if a text contains them.
TEST(Markup, TakesNoMarkOfItsOwnFromATextThatSpellsIt) {
    EXPECT_EQ(plainOf("\xee\x80\x80"
                      "0\xee\x80\x81 $x$"),
              "\xef\xbf\xbd"
              "0\xef\xbf\xbd x");
    EXPECT_EQ(plainOf("&#xE000;1&#xE001; $x$"),
              "\xee\x80\x80"
              "1\xee\x80\x81 x");
}

TEST(Markup, EscapesHtml) {
    EXPECT_EQ(htmlEscaped("<a href=\"b\">'&'</a>"),
              "&lt;a href=&quot;b&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
}

TEST(Markup, ItemsOfListsAppearOneByOneInBeamerAndMarp) {
    const std::string text = "- one\n- two $x$\n\n1. three\n\n\\- four\n\n    - code\n";
    const std::string latex = latexStepsOf(text);
    EXPECT_EQ(support::count(latex, "\\begin{itemize}[<+(1)->]"), 1);
    EXPECT_EQ(support::count(latex, "\\begin{enumerate}[<+(1)->]"), 1);
    EXPECT_EQ(support::count(latexOf(text), "<+"), 0);
    EXPECT_EQ(markdownStepsOf(text),
              "  * one\n  * two $x$\n\n[//]: #\n\n1)  three\n\n\\- four\n\n``` \n- code\n```");
    EXPECT_EQ(markdownStepsOf("words"), markdownOf("words"));
}

}  // namespace
}  // namespace demos::test
