/// LaTeX formulas as MathML, which browsers draw without a library: KaTeX, run by Duktape.
#pragma once
#include <stdexcept>
#include <string>

namespace demos {

constexpr std::size_t kLongestFormula = 2000;  // bytes

/// What KaTeX cannot read, and the byte of the formula where that is.
class FormulaError : public std::runtime_error {
public:
    FormulaError(std::size_t at, const std::string& what) : runtime_error(what), at_(at) {}
    std::size_t at() const { return at_; }

private:
    std::size_t at_;
};

/// A <math> element with the formula as its alttext; `display`: on a line of its own. Throws
/// FormulaError, also for what a page should not do: links, pictures, classes and styles. There is
/// one interpreter, so not for two threads at once.
std::string mathMlOf(const std::string& tex, bool display);

}  // namespace demos
