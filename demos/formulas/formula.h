/// LaTeX formulas as MathML, which browsers draw without a library: KaTeX, run by Duktape.
#pragma once
#include <stdexcept>
#include <string>

namespace demos {

constexpr std::size_t kLongestFormula = 2000;  // bytes

/// KaTeX cannot read a formula; `at`: the byte of the formula.
class FormulaError : public std::runtime_error {
public:
    FormulaError(std::size_t at, const std::string& what) : runtime_error(what), at_(at) {}
    std::size_t at() const { return at_; }

private:
    std::size_t at_;
};

/// A <math> element with the formula as its alttext; `display`: on its own line. Throws
/// FormulaError, also for links, pictures, classes and styles. There is one interpreter: not
/// thread-safe.
std::string mathMlOf(const std::string& tex, bool display);

}  // namespace demos
