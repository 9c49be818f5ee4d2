/// Converts words of a slide for each output. They are CommonMark (libcmark) in which $x$ is a
/// formula within a line and $$x$$ one on its own line; \$ is a dollar. Raw HTML is shown as text,
/// links go only to http, https and mailto, pictures are replaced by their descriptions. Quotes, --
/// and ... become typographic ones, except in code.
#pragma once
#include <string>

namespace demos {

// These throw FormulaError with the byte of the text.
std::string htmlOf(const std::string& commonMark);
/// The same without the paragraph around it, for a title or a caption of one line.
std::string htmlInlineOf(const std::string& commonMark);

/// For Beamer with amsmath and hyperref, and T1 or another encoding that has \textquotedbl.
/// (latex.cpp)
std::string latexOf(const std::string& commonMark);
std::string latexInlineOf(const std::string& commonMark);
/// As latexOf(); the items of lists appear one after the other, on overlays.
std::string latexStepsOf(const std::string& commonMark);

/// For Marp: CommonMark with formulas, without HTML and without rules, which would begin a slide.
/// (markdown.cpp)
std::string markdownOf(const std::string& commonMark);
std::string markdownInlineOf(const std::string& commonMark);
/// As markdownOf(); the items of lists appear one after the other: Marp's "*" and "1)".
std::string markdownStepsOf(const std::string& commonMark);

/// One line without markup; formulas are LaTeX. For alt texts and names.
std::string plainOf(const std::string& commonMark);
/// The same for a window's title: "why λ≥0", if a formula is one line of letters.
std::string titleTextOf(const std::string& commonMark);

/// Escapes plain text: nothing in it is markup, a formula or a number (numbers.h).
std::string commonMarkOf(const std::string& plain);

std::string htmlEscaped(const std::string& text);
std::string latexEscaped(const std::string& text);     // (latex.cpp)
std::string markdownEscaped(const std::string& text);  // (markdown.cpp)
/// Lines in typewriter letters with spaces kept; works in any frame, not only in a fragile one.
std::string latexCodeOf(const std::string& code);
/// A formula that KaTeX accepts, in dollars or brackets. (latex.cpp)
std::string latexFormulaOf(const std::string& tex, bool display);

}  // namespace demos
