// The talk as LaTeX: pictures from media/, films as posters that open them.
#include <fmt/format.h>

#include <algorithm>

#include "demos/options/picture_options.h"
#include "demos/slides/beamer_preamble.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/markup.h"
#include "demos/slides/slide_layout.h"
#include "demos/slides/slide_media.h"
#include "demos/slides/table_columns.h"

namespace demos {
namespace {

std::string themeOf(const Deck& deck) {
    if (deck.theme != "dark") return {};
    return "\\setbeamercolor{background canvas}{bg=black!88}\n"
           "\\setbeamercolor{normal text}{fg=white!92!black}\n"
           "\\setbeamercolor{structure}{fg=cyan!45!white}\n";
}

std::string command(const char* name, const std::string& latex) {
    return latex.empty() ? "" : fmt::format("\\{}{{{}}}\n", name, latex);
}

std::string escapedUnlessEmpty(const std::string& text) {
    return text.empty() ? "" : latexEscaped(text);
}

std::string titleOf(const Deck& deck) {
    return command("title", deck.title.empty() ? "" : latexInlineOf(deck.title)) +
           command("subtitle", deck.subtitle.empty() ? "" : latexInlineOf(deck.subtitle)) +
           command("author", escapedUnlessEmpty(deck.author)) +
           fmt::format("\\date{{{}}}\n", escapedUnlessEmpty(deck.date));
}

std::string tableLatex(const MadeTable& table) {
    std::string columns;
    for (const bool number : numberColumns(table)) columns += number ? 'r' : 'l';
    const auto row = [](const std::vector<std::string>& cells) {
        std::string line;
        for (const std::string& cell : cells)
            line += (line.empty() ? "" : " & ") + std::string("{}") + escapedUnlessEmpty(cell);
        return line + " \\\\\n";
    };
    std::string latex = fmt::format(
        "\\fit{{\\footnotesize\\begin{{tabular}}{{{}}}\n\\toprule\n"
        "{}\\midrule\n",
        columns, row(table.head));
    for (const std::vector<std::string>& cells : table.rows) latex += row(cells);
    return latex + "\\bottomrule\n\\end{tabular}}\\par\n";
}

/// Whether amsmath allows the formula only in a display.
bool needsDisplay(const std::string& latex) {
    for (const char* word : {"\\tag", "\\begin{split}"})
        if (latex.find(word) != std::string::npos) return true;
    return !latex.starts_with("\\[") || !latex.ends_with("\\]");
}

/// Scales a formula down if it is too wide, which is not possible in a display.
std::string formulaLatex(const std::string& formula) {
    const std::string latex = latexFormulaOf(formula, true);
    if (needsDisplay(latex)) return latex + "\n";
    return "\\begin{center}\\fit{$\\displaystyle " + latex.substr(2, latex.size() - 4) +
           "$}\\end{center}\n";
}

/// A typewriter letter is 0.525 of its size wide; the frame's text is 380 pt wide.
std::string codeLatex(const std::string& code, double width) {
    std::size_t longest = 1, length = 0;
    for (const char c : code) {
        length = c == '\n' ? 0 : length + 1;
        longest = std::max(longest, length);
    }
    const double size = width * 380.0 / (0.525 * static_cast<double>(longest));  // pt
    const char* name = size > 9.0   ? "small"
                       : size > 8.0 ? "footnotesize"
                       : size > 7.0 ? "scriptsize"
                                    : "tiny";
    return fmt::format("{{\\{} {}}}\n", name, latexCodeOf(code));
}

/// `width`: their share of the width of the frame's text.
std::string wordsOf(const MadeSlide& made, double width) {
    const Slide& slide = made.slide;
    std::string latex;
    if (!slide.text.empty()) {
        latex += slide.reveal ? latexStepsOf(slide.text) : latexOf(slide.text);
        latex += "\n";
    }
    for (const std::string& formula : slide.formulas) latex += formulaLatex(formula);
    if (!slide.code.empty()) latex += codeLatex(slide.code, width);
    for (const MadeTable& table : made.tables) latex += tableLatex(table);
    return latex;
}

/// Pictures as large as their share of the line's width and of the frame's height.
std::string exhibitsOf(const MadeSlide& made, double height, bool inRow) {
    const auto count = static_cast<double>(picturesOf(made).size());
    const double width = inRow && count > 1.0 ? 0.96 / count : 1.0;
    std::string latex;
    for (std::size_t i = 0; i < picturesOf(made).size(); ++i) {
        const std::string picture = fmt::format(
            "\\includegraphics[width={:.2f}\\linewidth,height={:.2f}\\textheight,keepaspectratio]"
            "{{{}}}",
            width, inRow ? height : height / count, pictureName(made, i));
        const bool film = i == 0 && hasFilm(made);
        latex += film ? fmt::format("\\href{{run:{}}}{{{}}}", filmName(made), picture) : picture;
        latex += inRow ? "\n" : "\\par\n";
    }
    latex += "\\par\n";
    if (!made.slide.caption.empty())
        latex += "{\\footnotesize " + latexInlineOf(made.slide.caption) + "\\par}\n";
    return latex;
}

/// `width`: of the words, `height`: of the pictures, as shares of the frame's.
std::string columnsOf(const MadeSlide& made, double width, double height) {
    return fmt::format(
        "\\begin{{columns}}[c]\n\\column{{{:.2f}\\textwidth}}\n{}"
        "\\column{{{:.2f}\\textwidth}}\n\\centering\n{}\\end{{columns}}\n",
        width, wordsOf(made, width), 0.97 - width, exhibitsOf(made, height, false));
}

/// Pictures and words below the title, which takes half of the frame.
std::string openingOf(const MadeSlide& made) {
    constexpr double kHeight = 0.4;
    if (wordsOf(made, 1.0).empty()) return "\\centering\n" + exhibitsOf(made, kHeight, true);
    return columnsOf(made, 0.5, kHeight);
}

std::string layoutText(const MadeSlide& made) {
    switch (layoutOf(made)) {
        case SlideLayout::full:
            return "\\centering\n" + exhibitsOf(made, 0.72, true);
        case SlideLayout::beside:
            return columnsOf(made, 0.42, 0.7);
        case SlideLayout::even:
            return columnsOf(made, 0.5, 0.7);
        case SlideLayout::below:
            return wordsOf(made, 1.0) + "\\begin{center}\n" + exhibitsOf(made, 0.45, true) +
                   "\\end{center}\n";
        case SlideLayout::openingPictured:
            return openingOf(made);
        case SlideLayout::opening:
        case SlideLayout::plain:
            break;
    }
    return wordsOf(made, 1.0) + exhibitsOf(made, 0.0, true);
}

/// Beamer shrinks frames badly, so only a text that is certainly too long gets `shrink`.
std::string frameOf(const MadeSlide& made) {
    constexpr std::size_t kLong = 380;  // bytes of text
    std::string latex =
        made.slide.text.size() > kLong ? "\n\\begin{frame}[shrink]\n" : "\n\\begin{frame}\n";
    if (made.slide.opening) latex += "\\titlepage\n";
    if (!made.slide.opening && !made.slide.title.empty())
        latex += command("frametitle", latexInlineOf(made.slide.title));
    latex += layoutText(made) + "\\end{frame}\n";
    if (!made.slide.notes.empty()) latex += command("note", latexOf(made.slide.notes));
    return latex;
}

}  // namespace

std::string beamerOf(const MadeDeck& made) {
    std::string latex = themeOf(made.deck) + titleOf(made.deck) + "\\begin{document}\n";
    for (const MadeSlide& slide : made.slides) latex += frameOf(slide);
    return beamerPreamble(latex) + latex + "\n\\end{document}\n";
}

}  // namespace demos
