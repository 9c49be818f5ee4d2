#include "demos/regression/xml_element.h"

namespace demos {
namespace {

/// Replaces markup characters by entities (XML 1.0, 2.4).
std::string escapedXml(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    return out;
}

}  // namespace

void XmlElement::write(int depth, std::string& out) const {
    const std::string indent(static_cast<std::size_t>(depth), ' ');
    out += indent + "<" + name_;
    for (const auto& [name, value] : attributes_)
        out += " " + name + "=\"" + escapedXml(value) + "\"";
    if (children_.empty() && text_.empty()) {
        out += " />\n";
        return;
    }
    out += ">" + escapedXml(text_);
    if (!children_.empty()) out += "\n";
    for (const XmlElement& child : children_) child.write(depth + 1, out);
    if (!children_.empty()) out += indent;
    out += "</" + name_ + ">\n";
}

std::string XmlElement::document() const {
    std::string out = "<?xml version=\"1.0\"?>\n";
    write(0, out);
    return out;
}

}  // namespace demos
