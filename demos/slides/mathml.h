/// KaTeX's MathML as the browsers draw it. They know MathML Core, which has no bold or blackboard
/// letters by attribute (Unicode has them as letters), no columns to the right, no boxes and rules.
/// https://www.w3.org/TR/mathml-core/
#pragma once
#include <string>

namespace demos {

/// `katex`: what renderToString gives for `tex`, <span class="katex"> and all. Throws FormulaError
/// for what they cannot draw: \cancel and its kin.
std::string browserMathMl(const std::string& katex, const std::string& tex, bool display);

}  // namespace demos
