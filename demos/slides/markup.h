/// Words of a slide for the places where they go. CommonMark (libcmark) in which $x$ is a
/// formula within a line and $$x$$ one on a line of its own; \$ is a dollar. Raw HTML in it is
/// shown as text, links go to http, https and mailto only, pictures are their descriptions.
#pragma once
#include <string>

namespace demos {

// These throw FormulaError with the byte of the text.
std::string htmlOf(const std::string& commonMark);
/// The same without the paragraph around it, for a title or a caption of one line.
std::string htmlInlineOf(const std::string& commonMark);

/// For Beamer, which has amsmath and hyperref; with T1 or another encoding that knows
/// \textquotedbl. (latex.cpp)
std::string latexOf(const std::string& commonMark);
std::string latexInlineOf(const std::string& commonMark);

/// For Marp: CommonMark with formulas again, without HTML and without rules, which are where slides
/// begin. (markdown.cpp)
std::string markdownOf(const std::string& commonMark);
std::string markdownInlineOf(const std::string& commonMark);

/// One line without marks; formulas are LaTeX. For alt texts and names.
std::string plainOf(const std::string& commonMark);
/// The same for a window's title: "why λ≥0", where a formula is one line of letters.
std::string titleTextOf(const std::string& commonMark);

/// What says these very words: nothing in them is a mark, a formula or a number (numbers.h).
std::string commonMarkOf(const std::string& plain);

std::string htmlEscaped(const std::string& text);
std::string latexEscaped(const std::string& text);     // (latex.cpp)
std::string markdownEscaped(const std::string& text);  // (markdown.cpp)
/// Lines in a typewriter's letters, spaces kept; good in any frame, not in a fragile one only.
std::string latexCodeOf(const std::string& code);
/// A formula that KaTeX takes, in its dollars or brackets. (latex.cpp)
std::string latexFormulaOf(const std::string& tex, bool display);

}  // namespace demos
