/// A font for formulas, which a page carries: not every machine has one with their spacing.
#pragma once
#include <string>

namespace demos {

/// TeX Gyre Pagella Math's letters and signs, WOFF2, in base64; empty where the build had none.
const std::string& mathFont();

}  // namespace demos
