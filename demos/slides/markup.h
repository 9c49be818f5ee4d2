/// Words of a slide for the three places where they go. CommonMark (libcmark) in which $x$ is a
/// formula within a line and $$x$$ one on a line of its own; \$ is a dollar.
#pragma once
#include <string>

namespace demos {

std::string htmlOf(const std::string& commonMark);   // raw HTML in it is shown as text
std::string latexOf(const std::string& commonMark);  // for Beamer
std::string plainOf(const std::string& commonMark);  // one line for titles and alt texts: no marks

/// The same without the paragraph around it, for a title or a caption of one line.
std::string htmlInlineOf(const std::string& commonMark);
std::string latexInlineOf(const std::string& commonMark);

std::string htmlEscaped(const std::string& text);
std::string latexEscaped(const std::string& text);

}  // namespace demos
