#include "demos/formulas/formula_layout.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "demos/formulas/formula.h"
#include "demos/formulas/formula_boxes.h"
#include "demos/formulas/math_letters.h"
#include "demos/formulas/mathml_elements.h"
#include "render/glyphs.h"

namespace demos {
namespace {

constexpr std::string_view kRelations[] = {
    "=", "<", ">", "≤", "≥", "≠", "≈", "≡", "≃", "≅", "∝", "∼", "≪", "≫", "≲", "≳", "≺", "≻", "≐", "≜", "≔", ":", "⩽",
    "⩾", "→", "←", "↔", "⟶", "⟵", "⟷", "⇒", "⇐", "⇔", "⟹", "⟸", "⟺", "⇌", "↦", "⟼", "∈", "∉", "∋", "⊂", "⊃", "⊆", "⊇",
    "⊥", "∥", "∣", "⊢", "⊨"};
constexpr std::string_view kBinary[] = {"+", "−", "-", "±", "∓", "×", "⋅", "·", "∗", "*", "∘", "∙", "⋆", "∧", "∨",
                                        "⊗", "⊕", "⊖", "⊙", "∪", "∩", "∖", "÷"};
constexpr std::string_view kLarge[] = {"∑", "∏", "∐", "∫", "∬", "∭", "∮", "⋃", "⋂", "⋁", "⋀", "⨁", "⨂", "⨀"};
constexpr std::string_view kThinBack = "\u2009\u2063";  // KaTeX's \!

template <std::size_t N>
bool isAmong(std::string_view text, const std::string_view (&list)[N]) {
    return std::find(std::begin(list), std::end(list), text) != std::end(list);
}

/// The innermost base of scripts, accents and limits.
pugi::xml_node innermost(pugi::xml_node node) {
    constexpr std::string_view kScripted[] = {"msub", "msup", "msubsup", "munder", "mover", "munderover"};
    while (isAmong(node.name(), kScripted)) node = node.first_child();
    return node;
}
bool isRelation(pugi::xml_node node) {
    return isCalled(innermost(node), "mo") && isAmong(textOf(innermost(node)), kRelations);
}
bool isFence(pugi::xml_node node) { return isCalled(node, "mo") && node.attribute("fence").as_bool(); }

float emOf(const pugi::xml_attribute& length) {
    return std::clamp(std::strtof(length.value(), nullptr), -1.0f, 20.0f);
}

int drawable(char32_t letter) {
    std::string text;
    putCharacter(text, letter);
    if (!render::hasLetter(static_cast<int>(letter)))
        throw FormulaError(0, "the fonts of pictures lack the letter '" + text + "'");
    return static_cast<int>(letter);
}

float sizeOfLevel(int level) { return level <= 0 ? 1.0f : level == 1 ? 0.76f : 0.6f; }

/// The layout of MathML's elements.
class Layout {
public:
    /// `display`: fractions and sums at their full size, as between $$ and $$.
    explicit Layout(bool display) : display_(display) {}

    Formula of(pugi::xml_node node) {
        const std::string_view name = node.name();
        if (name == "mi" || name == "mn" || name == "mtext" || name == "ms") return letters(node, name == "mi");
        if (name == "mo") return isLarge(node) ? largeSign(node) : sign(node, size());
        if (name == "mspace") return space(emOf(node.attribute("width")) * size());
        if (name == "mfrac") return fraction(node);
        if (name == "msqrt") return rootBox(row(node), {}, size());
        if (name == "mroot") return rootBox(of(part(node, 0)), script(part(node, 1), level_ + 2), size());
        if (name == "msub" || name == "msup" || name == "msubsup") return scripts(node, name);
        if (name == "munder" || name == "mover" || name == "munderover") return stack(node, name);
        if (name == "mtable") return table(node);
        if (name == "mstyle") return styled(node);
        if (name == "mphantom") return phantom(node);
        if (name == "mpadded") return padded(node);
        return name == "annotation" ? Formula{} : lined(node);
    }

    /// Of a row: each relation begins the next one. `apart`: without the space before it.
    std::vector<Formula> pieces(pugi::xml_node node, bool apart) {
        std::vector<Formula> parts;
        Formula between;
        for (const pugi::xml_node child : node.children()) {
            parts.push_back(isFence(child) ? Formula{} : of(child));
            append(parts.back(), between);
        }
        std::vector<Formula> all(1);
        std::size_t i = 0;
        for (const pugi::xml_node child : node.children()) {
            const Spaces spaces = spacesOf(child);
            const bool next = i > 0 && isRelation(child) && !isRelation(child.previous_sibling());
            if (next) all.emplace_back();
            Formula& piece = all.back();
            if (!next || !apart) append(space(spaces.before), piece);
            append(isFence(child) ? fence(child, between) : parts[i], piece);
            append(space(spaces.after), piece);
            ++i;
            if (isLarge(child)) append(space(0.17f * size()), piece);
        }
        return all;
    }

private:
    float size() const { return sizeOfLevel(level_); }

    static pugi::xml_node part(pugi::xml_node node, int number) {
        pugi::xml_node child = node.first_child();
        while (number-- > 0) child = child.next_sibling();
        return child;
    }

    /// A variable of one letter is italic, a name such as sin upright.
    Formula letters(pugi::xml_node node, bool variable) const {
        std::string_view rest = textOf(node);
        if (rest == kThinBack) return space(-0.167f * size());
        std::vector<PlainLetter> all;
        while (!rest.empty()) all.push_back(plainLetterOf(popCharacter(rest)));
        const std::string_view style = node.attribute("style").value();
        const bool upright = std::string_view(node.attribute("mathvariant").value()) == "normal";
        Formula box;
        for (const PlainLetter& letter : all) {
            const bool general = letter.letter >= 0x2000 && letter.letter <= 0x205f;
            if (general && !render::hasLetter(static_cast<int>(letter.letter))) {
                append(space(0.2f * size()), box);  // one of Unicode's spaces
                continue;
            }
            const bool bold = letter.bold || style.find("bold") != std::string_view::npos;
            const bool single = variable && all.size() == 1 && !upright && !bold;
            const bool italic = letter.italic || single || style.find("italic") != std::string_view::npos;
            append(letterBox(drawable(letter.letter), {size(), italic, bold}), box);
        }
        return box;
    }

    /// With a least height (\big) it is stretched to it.
    static Formula sign(pugi::xml_node node, float size) {
        std::string_view rest = textOf(node);
        Formula box;
        if (isInvisible(rest) || rest.empty()) return box;
        if (const pugi::xml_attribute height = node.attribute("minsize")) {
            Formula least;
            least.ascent = 0.5f * emOf(height) * size + mathAxis(size);
            least.descent = least.ascent - 2.0f * mathAxis(size);
            return fenceBox(drawable(popCharacter(rest)), least, size);
        }
        while (!rest.empty()) append(letterBox(drawable(popCharacter(rest)), {size}), box);
        return box;
    }

    /// The space before and after an operator; none in scripts, as in TeX.
    struct Spaces {
        float before = 0.0f, after = 0.0f;
    };
    Spaces spacesOf(pugi::xml_node node) const {
        if (level_ > 0) return {};
        const pugi::xml_node before = node.previous_sibling(), next = node.next_sibling();
        if (isRelation(node)) return {isRelation(before) ? 0.0f : 0.28f, isRelation(next) ? 0.0f : 0.28f};
        if (!isCalled(node, "mo")) return {};
        const std::string_view text = textOf(node);
        Spaces spaces;
        const bool prefix = std::string_view(node.attribute("form").value()) == "prefix";
        if (isAmong(text, kBinary) && before && next && !prefix)
            spaces = {0.22f, 0.22f};
        else if (text == "," || text == ";")
            spaces = {0.0f, 0.25f};  // a list on one line
        if (node.attribute("lspace")) spaces.before = emOf(node.attribute("lspace"));
        if (node.attribute("rspace")) spaces.after = emOf(node.attribute("rspace"));
        return spaces;
    }

    Formula row(pugi::xml_node node) {
        Formula box;
        for (const Formula& piece : pieces(node, false)) append(piece, box);
        return box;
    }

    static bool isLarge(pugi::xml_node node) {
        if (node.name() != std::string_view("mo")) node = node.first_child();
        return isCalled(node, "mo") && isAmong(textOf(node), kLarge);
    }

    /// \left. has no letter.
    Formula fence(pugi::xml_node node, const Formula& between) const {
        std::string_view text = textOf(node);
        return text.empty() ? Formula{} : fenceBox(drawable(popCharacter(text)), between, size());
    }

    Formula at(int level, bool display, pugi::xml_node node) {
        const int levelBefore = std::exchange(level_, level);
        const bool displayBefore = std::exchange(display_, display);
        Formula box = of(node);
        level_ = levelBefore, display_ = displayBefore;
        return box;
    }
    Formula script(pugi::xml_node node, int level) { return node ? at(level, false, node) : Formula{}; }

    Formula fraction(pugi::xml_node node) {
        const bool bar = std::string_view(node.attribute("linethickness").value()) != "0px";
        const int level = display_ ? level_ : level_ + 1;
        return fractionBox(at(level, false, part(node, 0)), at(level, false, part(node, 1)), size(), bar);
    }

    /// The sign of a sum is larger than letters.
    Formula largeSign(pugi::xml_node node) const {
        Formula box = sign(node, (display_ ? 1.6f : 1.2f) * size()), centred = space(box.width);
        put(box, 0.0f, mathAxis(size()) - 0.5f * (box.ascent - box.descent), centred);
        return centred;
    }

    /// Primes and the sign for degrees, which fonts have in their place. Empty: another script.
    Formula raisedSign(pugi::xml_node script) const {
        Formula box;
        if (isCalled(script, "mrow")) {
            for (const pugi::xml_node part : script.children()) {
                const Formula one = raisedSign(part);
                if (one.letters.empty()) return {};
                append(one, box);
            }
            return box;
        }
        const std::string_view text = textOf(script);
        if (!isCalled(script, "mo") || (text != "′" && text != "∘")) return box;
        return letterBox(text == "∘" ? 0xb0 : 0x2032, {size()});
    }

    Formula scripts(pugi::xml_node node, std::string_view name) {
        const Formula base = of(part(node, 0));
        const bool upperOnly = name == "msup";
        const Formula raised = raisedSign(part(node, upperOnly ? 1 : 2));
        const Formula first = script(part(node, 1), level_ + 1);
        if (raised.letters.empty())
            return upperOnly ? scriptsBox(base, {}, first, size())
                             : scriptsBox(base, first, script(part(node, 2), level_ + 1), size());
        Formula box = upperOnly ? base : scriptsBox(base, first, {}, size());
        const float above = base.ascent - raised.ascent;  // of a fraction in parentheses
        put(raised, base.width, above > 0.1f * size() ? above : 0.0f, box);
        box.width = std::max(box.width, base.width + raised.width);
        return box;
    }

    Formula stack(pugi::xml_node node, std::string_view name) {
        const pugi::xml_node first = part(node, 1);
        std::string_view text = textOf(first);
        const bool upper = name == "mover";
        if (text == "⏟" || text == "⏞") return linedBox(of(part(node, 0)), {upper, !upper}, size());
        if (upper && node.attribute("accent").as_bool() && !text.empty())
            return accentBox(of(part(node, 0)), drawable(popCharacter(text)), size());
        const Formula base = of(part(node, 0));
        const Formula one = script(first, level_ + 1), two = script(part(node, 2), level_ + 1);
        return limitsBox(base, upper ? Formula{} : one, upper ? one : two, size());
    }

    Formula table(pugi::xml_node node) {
        std::vector<std::vector<Formula>> rows;
        std::vector<Column> columns;
        for (const pugi::xml_node line : node.children()) {
            rows.emplace_back();
            for (const pugi::xml_node cell : line.children()) {
                const std::string_view style = cell.attribute("style").value();
                const auto has = [&](const char* word) { return style.find(word) != std::string_view::npos; };
                if (columns.size() < rows.back().size() + 1)
                    columns.push_back({has("align:left") ? 0.0f : has("align:right") ? 1.0f : 0.5f,
                                       has("padding-left:0"), has("border-right")});
                rows.back().push_back(row(cell));
            }
        }
        return tableBox(rows, columns, size());
    }

    Formula styled(pugi::xml_node node) {
        const pugi::xml_attribute level = node.attribute("scriptlevel"), display = node.attribute("displaystyle");
        const int levelBefore = level_;
        const bool displayBefore = display_;
        if (level) level_ = level.as_int();
        if (display) display_ = display.as_bool();
        Formula box = row(node);
        level_ = levelBefore, display_ = displayBefore;
        return box;
    }

    Formula phantom(pugi::xml_node node) {
        Formula box = row(node);
        box.letters.clear();
        box.strokes.clear();
        return box;
    }

    /// \vphantom and \smash: no width or no height.
    Formula padded(pugi::xml_node node) {
        const auto none = [&](const char* name) {
            return std::string_view(node.attribute(name).value()).starts_with("0");
        };
        Formula box = row(node);
        if (none("width")) box.width = 0.0f;
        if (none("height")) box.ascent = 0.0f;
        if (none("depth")) box.descent = 0.0f;
        return box;
    }

    /// A row, with lines where its style has borders.
    Formula lined(pugi::xml_node node) {
        const std::string_view style = node.attribute("style").value();
        const auto has = [&](const char* word) { return style.find(word) != std::string_view::npos; };
        const bool all = has("border:");
        const Sides sides{all || has("border-top"), all || has("border-bottom"), all, all};
        const bool none = !sides.top && !sides.bottom;
        return none ? row(node) : linedBox(row(node), sides, size());
    }

    int level_ = 0;  // of scripts
    bool display_;
};

}  // namespace

std::vector<render::Formula> formulaLayout(const std::string& mathMl) {
    pugi::xml_document document;
    document.load_string(mathMl.c_str(), pugi::parse_default | pugi::parse_ws_pcdata_single);
    const pugi::xml_node math = document.document_element(), row = math.first_child();
    const bool only = isCalled(row, "mrow") && !row.next_sibling() && !row.attribute("style");
    const bool display = std::string_view(math.attribute("display").value()) == "block";
    std::vector<render::Formula> pieces = Layout(display).pieces(only ? row : math, true);
    std::size_t letters = 0;
    for (const render::Formula& piece : pieces) letters += piece.letters.size();
    if (letters > kMostFormulaLetters)
        throw FormulaError(0, "the formula has " + std::to_string(letters) +
                                  " letters; in a caption it should have at most " +
                                  std::to_string(kMostFormulaLetters));
    return pieces;
}

}  // namespace demos
