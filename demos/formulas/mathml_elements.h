/// Elements of MathML.
#pragma once
#include <pugixml.hpp>
#include <string_view>

namespace demos {

inline bool isCalled(pugi::xml_node node, std::string_view name) { return node.name() == name; }
inline std::string_view textOf(pugi::xml_node node) { return node.child_value(); }

/// The application of a function and products that are not drawn: U+2061 to U+2064.
inline bool isInvisible(std::string_view text) {
    return text.size() == 3 && text.starts_with("\xe2\x81") && text[2] >= '\xa1' && text[2] <= '\xa4';
}

}  // namespace demos
