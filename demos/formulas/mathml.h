/// Converts KaTeX's MathML to MathML Core, which browsers draw. It has no bold or blackboard
/// letters by attribute (Unicode has them as letters), no column alignment, no boxes and rules.
/// https://www.w3.org/TR/mathml-core/
#pragma once
#include <string>

namespace demos {

/// `katex`: the result of renderToString for `tex`, with <span class="katex">. Throws FormulaError
/// for what browsers cannot draw, such as \cancel.
std::string browserMathMl(const std::string& katex, const std::string& tex, bool display);

}  // namespace demos
