/// A font for formulas, embedded in pages: not every machine has a math font.
#pragma once
#include <string>

namespace demos {

/// TeX Gyre Pagella Math's letters and signs as WOFF2 in base64; empty if the build had no font.
const std::string& mathFont();

/// The style by which a page has it as "impulse math"; empty likewise. (slides_page.cpp)
std::string mathFontStyle();

}  // namespace demos
