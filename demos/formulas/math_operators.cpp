#include "demos/formulas/math_operators.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "demos/formulas/mathml_elements.h"

namespace demos {
namespace {

constexpr std::string_view kApply = "\u2061";  // follows the name of a function
constexpr const char* kThin = "0.1667em";      // TeX's \, : 3/18 of a quad

/// TeX's kinds of atom, as far as they matter for spacing.
enum class Atom { none, space, term, function, open, bracketed, close, sign };

template <std::size_t N>
bool isOneOf(std::string_view text, const std::string_view (&list)[N]) {
    return std::find(std::begin(list), std::end(list), text) != std::end(list);
}

bool isElement(pugi::xml_node node) { return node.type() == pugi::node_element; }

bool isToken(pugi::xml_node node) {
    return isCalled(node, "mo") || isCalled(node, "mi") || isCalled(node, "mn");
}

/// Whether the element has a base and scripts above, below or beside it.
bool isScripted(pugi::xml_node node) {
    return isOneOf(node.name(), {"msub", "msup", "msubsup", "munder", "mover", "munderover"});
}

/// The joined texts of tokens; empty if there is anything else.
std::string flatText(pugi::xml_node node) {
    std::string text;
    for (const pugi::xml_node child : node.children()) {
        const bool row = isCalled(child, "mrow");
        const std::string part = row || isToken(child) ? flatText(child) : "";
        if (isElement(child) && part.empty()) return "";
        text += isElement(child) ? part : child.value();
    }
    return text;
}

/// KaTeX puts elements into <mo> and <mi>, where browsers support only text.
pugi::xml_node unwrapped(pugi::xml_node token) {
    if (!isToken(token) || !isElement(token.first_child())) return token;
    const bool row = isCalled(token.first_child(), "mrow");  // letters, as of \bmod
    if (token.first_child() == token.last_child() && !row) {
        pugi::xml_node parent = token.parent();
        const pugi::xml_node only = parent.insert_move_before(token.first_child(), token);
        parent.remove_child(token);
        return unwrapped(only);
    }
    const std::string text = flatText(token);
    if (text.empty() || text.find(kApply) != std::string::npos) {
        token.set_name("mrow");
    } else {
        token.remove_children();
        token.append_child(pugi::node_pcdata).set_value(text.c_str());
    }
    return token;
}

void unwrapTokens(pugi::xml_node node) {
    for (pugi::xml_node child = node.first_child(); child; child = child.next_sibling()) {
        child = unwrapped(child);
        unwrapTokens(child);
    }
}

void setUnlessGiven(pugi::xml_node node, const char* name, const char* value) {
    if (!node.attribute(name)) node.append_attribute(name) = value;
}

/// For a fence's bar KaTeX uses the sign for "divides", a relation, which does not stretch.
void setBar(pugi::xml_node sign) {
    const std::string_view text = textOf(sign);
    const bool one = text == "\u2223" || text == "|", two = text == "\u2225";
    const bool fence = sign.attribute("fence");  // \lvert is no fence in KaTeX and does not stretch
    if ((!one && !two) || (!fence && !sign.attribute("stretchy"))) return;
    sign.text().set(one ? "|" : "\u2016");
    if (fence) {
        setUnlessGiven(sign, "stretchy", "true");
        setUnlessGiven(sign, "symmetric", "true");
    }
    for (const char* side : {"lspace", "rspace"}) setUnlessGiven(sign, side, "0");
}

int letters(pugi::xml_node node) {
    if (!isElement(node)) return 0;
    int count = isElement(node.first_child()) ? 0 : 1;
    for (const pugi::xml_node child : node.children()) count += letters(child);
    return count;
}

/// A line becomes a border, and an accent the sign that fonts have in several widths. Browsers do
/// not use such widths of a tilde: it is scaled.
void setWideAccent(pugi::xml_node node) {
    const pugi::xml_node base = node.first_child(), sign = node.last_child();
    if (!sign.attribute("stretchy").as_bool()) return;
    const std::string_view text = textOf(sign);
    if (text == "\u203e") {
        const char* side = isCalled(node, "munder") ? "bottom" : "top";
        for (const char* name : {"accent", "accentunder"}) node.remove_attribute(name);
        node.remove_child(sign);
        node.set_name("mrow");
        node.append_attribute("style") =
            fmt::format("border-{0}:0.06em solid;padding-{0}:0.12em;", side).c_str();
    } else if (text == "^") {
        sign.text().set("\u0302");
    } else if (text == "~") {
        pugi::xml_node wide = sign;
        wide.attribute("stretchy") = "false";
        wide.append_attribute("style") =
            fmt::format("transform:scaleX({:.1f});", std::max(1.0, 0.8 * letters(base))).c_str();
    }
}

bool isBlank(std::string_view text) {
    // Spaces of Unicode are U+00A0, U+2000..U+200B, U+202F and U+205F.
    while (!text.empty()) {
        const bool one = text[0] == ' ';
        const bool three = text.starts_with("\xe2\x80") || text.starts_with("\u205f");
        const std::size_t length = one ? 1 : text.starts_with("\u00a0") ? 2 : three ? 3 : 0;
        if (length == 0) return false;
        text.remove_prefix(std::min(length, text.size()));
    }
    return true;
}

/// The innermost base of scripts and stacks.
pugi::xml_node baseOf(pugi::xml_node node) {
    while (isScripted(node)) node = node.first_child();
    return node;
}

/// A bar that is not a fence opens if an even number of its kind precede it in its row.
Atom atomOfBar(pugi::xml_node bar) {
    const std::string_view text = textOf(bar);
    while (isScripted(bar.parent())) bar = bar.parent();
    bool opens = true;
    while ((bar = bar.previous_sibling()))
        if (textOf(baseOf(bar)) == text) opens = !opens;
    return opens ? Atom::open : Atom::close;
}

Atom atomOfSign(pugi::xml_node sign) {
    const std::string_view text = textOf(sign);
    if (text == kApply) return Atom::function;
    if (text == "|" || text == "\u2016") {
        if (!sign.attribute("fence")) return atomOfBar(sign);
        return sign.next_sibling() ? Atom::open : Atom::close;
    }
    if (isOneOf(text, {"(", "[", "{", "\u27e8", "\u230a", "\u2308"})) return Atom::open;
    if (isOneOf(text, {")", "]", "}", "\u27e9", "\u230b", "\u2309", "!", "\u2032", "\u2026",
                       "\u22ef", "\u22ee", "\u22f1"}))
        return Atom::close;
    return Atom::sign;
}

Atom atomOf(pugi::xml_node node);

Atom atomOfRow(pugi::xml_node row) {
    if (!row.first_child()) return Atom::term;
    if (textOf(row.last_child()) == kApply) return Atom::function;
    if (row.first_child() == row.last_child() && isScripted(row.first_child()))
        return atomOf(row.first_child());
    return isCalled(row.first_child(), "mo") && atomOfSign(row.first_child()) == Atom::open
               ? Atom::bracketed
               : Atom::term;
}

Atom atomOf(pugi::xml_node node) {
    if (!node) return Atom::none;
    if (isCalled(node, "mspace")) return Atom::space;
    if (isCalled(node, "mtext") && isBlank(textOf(node))) return Atom::space;
    if (isCalled(node, "mo")) return atomOfSign(node);
    if (isCalled(node, "mi") && textOf(node.next_sibling()) == kApply) return Atom::function;
    if (isCalled(node, "mi") && isOneOf(textOf(node), {"\u2223", "\u2225"})) return atomOfBar(node);
    if (isCalled(node, "mrow")) return atomOfRow(node);
    return isScripted(node) ? atomOf(node.first_child()) : Atom::term;
}

/// A minus after a relation, a bracket or another sign is a prefix.
void setUnary(pugi::xml_node sign, Atom before) {
    const bool follows = before == Atom::open || before == Atom::sign || before == Atom::function;
    if (follows && sign.next_sibling() &&
        isOneOf(textOf(sign), {"\u2212", "-", "+", "\u00b1", "\u2213"}))
        setUnlessGiven(sign, "form", "prefix");
}

/// A thin space as in sin x, 2 sin x and sin x cos x, but not in sin(x).
bool isParted(Atom left, Atom right) {
    if (left == Atom::function) return right == Atom::term || right == Atom::function;
    return right == Atom::function &&
           (left == Atom::term || left == Atom::close || left == Atom::bracketed);
}

void spaceRow(pugi::xml_node row) {
    Atom before = Atom::none, last = Atom::none;  // `before`: not a space
    for (pugi::xml_node child : row.children()) {
        const Atom atom = atomOf(child);
        if (atom == Atom::sign) setUnary(child, before);
        // A name and its U+2061 belong together.
        if (textOf(child) != kApply && isParted(last, atom))
            row.insert_child_before("mspace", child).append_attribute("width") = kThin;
        last = atom;
        if (atom != Atom::space) before = atom;
    }
}

void adaptNode(pugi::xml_node node) {
    for (pugi::xml_node child : node.children()) adaptNode(child);
    if (isCalled(node, "mo")) setBar(node);
    if (isCalled(node, "mover") || isCalled(node, "munder")) setWideAccent(node);
    if (isOneOf(node.name(), {"math", "mrow", "mstyle", "mtd", "mpadded", "msqrt"})) spaceRow(node);
}

}  // namespace

void adaptOperators(pugi::xml_node root) {
    unwrapTokens(root);
    adaptNode(root);
}

}  // namespace demos
