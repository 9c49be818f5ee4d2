/// Formulas laid out with the letters of pictures, for captions.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "render/formula.h"

namespace demos {

constexpr std::size_t kMostFormulaLetters = 500;

/// Returns pieces between which a line can be broken: all but the first begin with a relation such as =.
/// `mathMl`: as mathMlOf() returns it. Throws FormulaError if it has too many letters.
std::vector<render::Formula> formulaLayout(const std::string& mathMl);

}  // namespace demos
