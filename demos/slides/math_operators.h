/// Operators of KaTeX's MathML as browsers lay them out: what is stacked, bars and lines that
/// stretch, a minus that belongs to what follows, room around the names of functions.
#pragma once
#include <pugixml.hpp>

namespace demos {

/// Of all that is in `root`. What KaTeX says of an operator's spaces stays as it is.
void adaptOperators(pugi::xml_node root);

}  // namespace demos
