/// The preamble of the Beamer document.
#pragma once
#include <string>

namespace demos {

/// Packages, KaTeX's commands that LaTeX lacks, and declarations of every letter in `body` at which
/// pdfLaTeX would stop.
std::string beamerPreamble(const std::string& body);

}  // namespace demos
