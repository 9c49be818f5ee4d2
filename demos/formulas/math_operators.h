/// Adapts operators of KaTeX's MathML to browsers: stacked operators, bars and lines that stretch,
/// a prefix minus, spaces around the names of functions.
#pragma once
#include <pugixml.hpp>

namespace demos {

/// Adapts all operators in `root`. Spaces that KaTeX sets on an operator stay as they are.
void adaptOperators(pugi::xml_node root);

}  // namespace demos
