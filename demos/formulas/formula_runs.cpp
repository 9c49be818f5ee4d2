#include "demos/formulas/formula_runs.h"

#include <string_view>

#include "demos/formulas/math_letters.h"
#include "demos/formulas/mathml_elements.h"

namespace demos {
namespace {

/// Relations and operators that have space on both sides between two terms.
constexpr std::string_view kSpaced[] = {"=", "+", "−", "×", "·", "⋅", "±", "<", ">", "≤", "≥",
                                        "≈", "≠", "→", "∈", "≪", "≫", "∝", "≡", "⇒"};

bool isAmongSpaced(std::string_view text) {
    for (const std::string_view sign : kSpaced)
        if (sign == text) return true;
    return false;
}

constexpr const char* kThinSpace = "\xe2\x80\x89";  // U+2009

/// The sign over a letter as one that combines with it; empty: there is none.
std::string_view combining(std::string_view sign) {
    if (sign == "ˉ" || sign == "‾" || sign == "¯") return "\xcc\x84";
    if (sign == "˙") return "\xcc\x87";
    if (sign == "¨") return "\xcc\x88";
    if (sign == "^" || sign == "ˆ") return "\xcc\x82";
    if (sign == "~" || sign == "˜") return "\xcc\x83";
    if (sign == "⃗" || sign == "→") return "\xe2\x83\x97";
    return {};
}

class LineWriter {
public:
    std::vector<FormulaRun> runs;

    void write(pugi::xml_node node) {
        const std::string_view name = node.name();
        if (name == "mi" || name == "mn" || name == "mtext" || name == "ms")
            writeLetters(node, name == "mi");
        else if (name == "mo")
            writeOperator(node);
        else if (name == "mspace")
            put(" ", false, false);
        else if (name == "mfrac")
            writeFraction(node);
        else if (name == "msqrt" || name == "mroot")
            writeRoot(node);
        else if (name.starts_with("msu") || name == "mover" || name.starts_with("munder"))
            writeScripts(node, name);
        else if (name == "mtr")
            writeRow(node);
        else if (name != "annotation" && name != "mphantom")
            writeAll(node);
    }

private:
    void put(const std::string& text, bool italic, bool bold) {
        if (text.empty()) return;
        if (!runs.empty() && runs.back().italic == italic && runs.back().bold == bold &&
            runs.back().level == level_)
            runs.back().text += text;
        else
            runs.push_back({text, italic, bold, level_});
    }

    void writeAll(pugi::xml_node node) {
        for (const pugi::xml_node child : node.children()) write(child);
    }

    /// A variable of one letter is italic, a name such as sin upright.
    void writeLetters(pugi::xml_node node, bool variable) {
        const std::string text = node.text().get();
        std::string_view rest = text;
        std::size_t letters = 0;
        while (!rest.empty()) {
            popCharacter(rest);
            ++letters;
        }
        const bool upright = std::string_view(node.attribute("mathvariant").value()) == "normal";
        rest = text;
        while (!rest.empty()) {
            const PlainLetter plain = plainLetterOf(popCharacter(rest));
            std::string one;
            putCharacter(one, plain.letter);
            const bool italic = variable && letters == 1 && !upright && !plain.bold;
            put(one, plain.italic || italic, plain.bold);
        }
    }

    void writeOperator(pugi::xml_node node) {
        const std::string text = node.text().get();
        if (isInvisible(text)) return;
        const std::string_view before = node.previous_sibling().name();
        const bool between =
            level_ == 0 && !before.empty() && before != "mo" && node.next_sibling();
        const bool spaced = isAmongSpaced(text) && (between || text == "=");
        put(spaced ? " " + text + " " : text == "," ? ", " : text, false, false);
    }

    /// In parentheses if it has several parts.
    void writeTerm(pugi::xml_node node) {
        pugi::xml_node inner = node;
        while ((isCalled(inner, "mrow") || isCalled(inner, "mstyle")) && inner.first_child() &&
               !inner.first_child().next_sibling())
            inner = inner.first_child();
        const bool several = isCalled(inner, "mfrac") || (isCalled(inner, "mrow") && !isSimple(inner));
        if (several) put("(", false, false);
        write(node);
        if (several) put(")", false, false);
    }

    /// Only letters, numbers and their indices: Δt.
    static bool isSimple(pugi::xml_node row) {
        for (const pugi::xml_node child : row.children()) {
            const std::string_view name = child.name();
            if (name != "mi" && name != "mn" && !name.starts_with("msu")) return false;
        }
        return true;
    }

    /// With a little space before the next term: it is not in the denominator.
    void writeFraction(pugi::xml_node node) {
        writeTerm(node.first_child());
        const bool bar = std::string_view(node.attribute("linethickness").value()) != "0px";
        put(bar ? "/" : " over ", false, false);
        writeTerm(node.first_child().next_sibling());
        const std::string_view next = node.next_sibling().name();
        if (!next.empty() && next != "mo") put(kThinSpace, false, false);
    }

    void writeRoot(pugi::xml_node node) {
        const bool nth = std::string_view(node.name()) == "mroot";
        if (nth) writeAt(1, node.last_child());
        put("√(", false, false);
        if (nth)
            write(node.first_child());
        else
            writeAll(node);
        put(")", false, false);
    }

    /// A script of a script stands on the line of the first one: 2 to the n^2.
    void writeAt(int level, pugi::xml_node node) {
        const bool nested = level_ != 0, several = nested && isCalled(node, "mrow");
        if (nested) put(level > 0 ? "^" : "_", false, false);
        if (several) put("(", false, false);
        if (!nested) level_ = level;
        write(node);
        if (!nested) level_ = 0;
        if (several) put(")", false, false);
    }

    void writeScripts(pugi::xml_node node, std::string_view name) {
        const pugi::xml_node base = node.first_child(), first = base.next_sibling();
        const bool upper = name == "msup" || name == "mover";
        write(base);
        const std::string_view sign = combining(first.text().get());
        const std::string_view text = first.text().get();
        if (text == "⏟" || text == "⏞") return;
        if (upper && !sign.empty() && !runs.empty()) {
            runs.back().text += sign;
            return;
        }
        writeAt(upper ? 1 : -1, first);
        if (first.next_sibling()) writeAt(1, first.next_sibling());
    }

    void writeRow(pugi::xml_node row) {
        for (const pugi::xml_node cell : row.children()) {
            write(cell);
            if (cell.next_sibling()) put(" ", false, false);
        }
        if (row.next_sibling()) put("; ", false, false);
    }

    int level_ = 0;
};

}  // namespace

std::vector<FormulaRun> formulaRuns(const std::string& mathMl) {
    pugi::xml_document document;
    if (!document.load_string(mathMl.c_str(), pugi::parse_default | pugi::parse_ws_pcdata_single))
        return {{mathMl, false, false, 0}};
    LineWriter writer;
    writer.write(document.document_element());
    return writer.runs;
}

}  // namespace demos
