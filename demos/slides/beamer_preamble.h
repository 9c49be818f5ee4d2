/// What LaTeX has to know before the frames begin.
#pragma once
#include <string>

namespace demos {

/// Packages, KaTeX's words that LaTeX lacks, and declarations of every letter in `body` that
/// pdfLaTeX would stop at.
std::string beamerPreamble(const std::string& body);

}  // namespace demos
