#include "demos/formulas/mathml.h"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <vector>

#include "demos/formulas/formula.h"
#include "demos/formulas/math_letters.h"
#include "demos/formulas/math_operators.h"

namespace demos {
namespace {

/// Text within a formula keeps its letters, for search and screen readers.
std::string textStyle(const std::string& variant) {
    std::string style;
    const auto has = [&](const char* word) { return variant.find(word) != std::string::npos; };
    if (has("bold")) style += "font-weight:bold;";
    if (has("italic")) style += "font-style:italic;";
    if (has("sans-serif")) style += "font-family:sans-serif;";
    if (has("monospace")) style += "font-family:monospace;";
    return style;
}

void setStyle(pugi::xml_node node, const std::string& style) {
    if (!style.empty()) node.append_attribute("style") = style.c_str();
}

void setVariant(pugi::xml_node node) {
    const std::string variant = node.attribute("mathvariant").value();
    if (variant.empty() || variant == "normal") return;
    node.remove_attribute("mathvariant");
    if (std::string_view(node.name()) == "mtext") return setStyle(node, textStyle(variant));
    pugi::xml_node text = node.first_child();
    text.set_value(inVariant(text.value(), variant).c_str());
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> list;
    for (std::string word; stream >> word;) list.push_back(word);
    return list;
}

/// An item of a table's attribute: the last word applies to all further items.
std::string wordAt(const std::vector<std::string>& list, std::size_t i) {
    return list.empty() ? "" : list[std::min(i, list.size() - 1)];
}

/// Styles of a table's cells from the table's attributes. Where KaTeX has no space between two
/// columns, as within `aligned`, the cells have none.
class Cells {
public:
    explicit Cells(pugi::xml_node table)
        : sides_(words(table.attribute("columnalign").value())),
          gaps_(words(table.attribute("columnspacing").value())),
          columnLines_(words(table.attribute("columnlines").value())),
          rowLines_(words(table.attribute("rowlines").value())) {}

    std::string styleOf(std::size_t row, std::size_t column, bool lastRow, bool lastColumn) const {
        std::string style;
        const std::string side = wordAt(sides_, column);
        if (side == "left" || side == "right") style = "text-align:" + side + ";";
        if (column > 0 && wordAt(gaps_, column - 1) == "0em") style += "padding-left:0;";
        if (!lastColumn && wordAt(gaps_, column) == "0em") style += "padding-right:0;";
        if (!lastColumn) style += line("right", wordAt(columnLines_, column));
        if (!lastRow) style += line("bottom", wordAt(rowLines_, row));
        return style;
    }

private:
    static std::string line(const std::string& side, const std::string& kind) {
        const bool drawn = kind == "solid" || kind == "dashed";
        return drawn ? "border-" + side + ":0.06em " + kind + ";" : "";
    }

    std::vector<std::string> sides_, gaps_, columnLines_, rowLines_;
};

void styleCells(pugi::xml_node table) {
    const Cells cells(table);
    std::size_t row = 0;
    for (pugi::xml_node line : table.children()) {
        std::size_t column = 0;
        for (pugi::xml_node cell : line.children())
            setStyle(cell,
                     cells.styleOf(row, column++, !line.next_sibling(), !cell.next_sibling()));
        ++row;
    }
    for (const char* name :
         {"columnalign", "columnspacing", "rowspacing", "columnlines", "rowlines"})
        table.remove_attribute(name);
}

/// A box is drawn by its style. A stroke through a term is refused: browsers would ignore it.
void styleEnclosed(pugi::xml_node node) {
    const std::string_view notation = node.attribute("notation").value();
    if (notation != "box")
        throw FormulaError(0, "'" + std::string(notation) +
                                  "' around a term is not supported; leave it out, or use \\boxed");
    node.set_name("mrow");
    node.remove_attribute("notation");
    setStyle(node, "border:0.06em solid;padding:0.3em;");
}

/// Replaces the arrow of \vec: it is a combining character and would join the term before it.
void setAccent(pugi::xml_node node) {
    if (std::string_view(node.child_value()) != "\u20d7") return;
    node.first_child().set_value("\u2192");
    for (const char* none : {"lspace", "rspace"}) node.append_attribute(none) = "0";
    node.append_attribute("stretchy") = "false";
}

void adapt(pugi::xml_node node) {
    const std::string_view name = node.name();
    setVariant(node);
    if (name == "mo") setAccent(node);
    if (name == "mtable") styleCells(node);
    if (name == "menclose") styleEnclosed(node);
    for (pugi::xml_node child : node.children()) adapt(child);
}

}  // namespace

std::string browserMathMl(const std::string& katex, const std::string& tex, bool display) {
    pugi::xml_document read;
    read.load_buffer(katex.data(), katex.size(), pugi::parse_default | pugi::parse_ws_pcdata,
                     pugi::encoding_utf8);
    pugi::xml_document made;
    pugi::xml_node math = made.append_child("math");
    math.append_attribute("xmlns") = "http://www.w3.org/1998/Math/MathML";
    if (display) math.append_attribute("display") = "block";
    math.append_attribute("alttext") = tex.c_str();
    const pugi::xml_node semantics = read.child("span").child("math").child("semantics");
    for (const pugi::xml_node node : semantics.children())
        if (std::string_view(node.name()) != "annotation") adapt(math.append_copy(node));
    adaptOperators(math);
    std::ostringstream text;
    made.save(text, "", pugi::format_raw | pugi::format_no_declaration, pugi::encoding_utf8);
    return text.str();
}

}  // namespace demos
