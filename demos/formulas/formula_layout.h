/// Formulas laid out with the letters of pictures, for captions.
#pragma once
#include <cstddef>
#include <string>

#include "render/formula.h"

namespace demos {

constexpr std::size_t kMostFormulaLetters = 500;

/// `mathMl`: as mathMlOf() returns it. Throws FormulaError if it has too many letters.
render::Formula formulaLayout(const std::string& mathMl);

}  // namespace demos
