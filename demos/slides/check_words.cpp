#include "demos/slides/check_words.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "demos/formulas/formula.h"
#include "demos/formulas/text_formulas.h"
#include "demos/slides/numbers.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

/// The names of all bodies or joints.
template <class Thing>
std::vector<std::string> namesOf(const std::vector<Thing>& things) {
    std::vector<std::string> names;
    for (const Thing& thing : things) names.push_back(thing.name);
    return names;
}

/// A message if the run has no body or joint of the name; empty if it has.
std::string whyNone(const char* kind, const std::string& name,
                    const std::vector<std::string>& names, const std::string& scene) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return "";
    return "no " + std::string(kind) + " of '" + scene + "' is called '" + shown(name) + "'" +
           (names.empty() ? "; it has none" : suggestion(name, names));
}

std::string whyNoExpectation(const NumberName& name, const SceneDescription& scene) {
    std::size_t number = 0;
    std::from_chars(name.of.data(), name.of.data() + name.of.size(), number);
    const std::size_t count = scene.expectations.size();
    if (number <= count) return "";
    return "'" + scene.name + "' has " + std::to_string(count) +
           " [[expect]]; there is no expectation " + name.of;
}

/// A message if no run gives this number; empty if one does.
std::string whyNoNumber(const NumberName& name, const std::vector<SceneDescription>& runs) {
    if (runs.empty()) return "there is no run here to take numbers from; name a scene";
    if (name.run > static_cast<int>(runs.size()))
        return "there is no run " + std::to_string(name.run) + "; the slide has " +
               std::to_string(runs.size());
    const SceneDescription& scene = runs[static_cast<std::size_t>(name.run) - 1];
    if (name.group == "body") return whyNone("body", name.of, namesOf(scene.bodies), scene.name);
    if (name.group == "joint") return whyNone("joint", name.of, namesOf(scene.joints), scene.name);
    return name.group == "expect" ? whyNoExpectation(name, scene) : "";
}

constexpr const char* kLostBackslash =
    ", written as an escape; write LaTeX in single quotes, which keep its backslashes";

bool isControl(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\t' && c != '\r') || byte == 0x7f;
}

/// The escapes in "\beta" and "\frac".
bool isLatexEscape(char c) { return c == '\b' || c == '\f'; }

class WordsCheck {
public:
    WordsCheck(const TomlPosition& position, Complaints& complaints)
        : position_(position), complaints_(complaints) {}

    void complain(std::size_t byte, const std::string& what) {
        complaints_.add(placeIn(position_, byte), what);
    }

    bool isText(const std::string& text) {
        if (text.size() > kMostWords) {
            complain(0, "the text has " + std::to_string(text.size()) +
                            " bytes; it should have at most " + std::to_string(kMostWords));
            return false;
        }
        const auto control = std::find_if(text.begin(), text.end(), isControl);
        if (control == text.end()) return true;
        const auto byte = static_cast<std::size_t>(control - text.begin());
        complain(byte, isEscape(position_, byte) && isLatexEscape(*control)
                           ? "a control byte" + std::string(kLostBackslash)
                           : "a control byte; take it out");
        return false;
    }

    /// Nothing if a number is malformed, which is reported.
    std::optional<NumberedText> numbersIn(const std::string& text,
                                          const std::vector<SceneDescription>& runs) {
        NumberedText parts;
        try {
            parts = numberedText(text);
        } catch (const NumberError& error) {
            complain(error.at(), error.what());
            return std::nullopt;
        }
        for (std::size_t i = 0; i < parts.numbers.size(); ++i) {
            const std::string why = whyNoNumber(parts.numbers[i], runs);
            if (!why.empty()) complain(parts.places[i], why);
        }
        return parts;
    }

    /// "\theta" in double quotes is a tab and "heta", "\nabla" a new line and "abla".
    bool keepsBackslashes(const std::string& text, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const char c = text[i];
            if ((c != '\t' && c != '\n' && c != '\r') || !isEscape(position_, i)) continue;
            complain(i, (c == '\t' ? "a tab" : "a line break") + std::string(" in a formula") +
                            kLostBackslash);
            return false;
        }
        return true;
    }

    /// In "$\theta$" in double quotes, the space after the dollar is a tab made from the backslash.
    void complainOfDollar(const std::string& text, std::size_t dollar) {
        if (!keepsBackslashes(text, dollar + 1, std::min(dollar + 2, text.size()))) return;
        complain(
            dollar,
            "a $ that neither begins nor ends a formula; write \\$ for a dollar, and a formula "
            "with no space inside its dollars");
    }

    template <class Read>
    void readFormula(const Read& read) {
        try {
            read();
        } catch (const FormulaError& error) {
            complain(error.at(), "formula: " + std::string(error.what()));
        }
    }

private:
    const TomlPosition& position_;
    Complaints& complaints_;
};

}  // namespace

void checkWords(const std::string& words, const TomlPosition& position,
                const std::vector<SceneDescription>& runs, Complaints& complaints) {
    WordsCheck check(position, complaints);
    if (!check.isText(words)) return;
    const std::optional<NumberedText> parts = check.numbersIn(words, runs);
    if (!parts) return;
    const ScannedText scanned = scannedText(maskedNumbers(words, *parts, 'x'));
    if (!scanned.loose.empty()) check.complainOfDollar(words, scanned.loose.front());
    const std::string digits = maskedNumbers(words, *parts, '1');
    for (TextFormula formula : scanned.formulas) {
        formula.tex = digits.substr(formula.at, formula.tex.size());
        if (check.keepsBackslashes(words, formula.begin, formula.end))
            check.readFormula([&] { mathMlIn(formula); });
    }
}

void checkFormula(const std::string& tex, const TomlPosition& position,
                  const std::vector<SceneDescription>& runs, Complaints& complaints) {
    WordsCheck check(position, complaints);
    if (tex.find_first_not_of(" \t\r\n") == std::string::npos)
        return check.complain(0, "the formula is empty; write LaTeX, or leave it out");
    if (!check.isText(tex)) return;
    const std::optional<NumberedText> parts = check.numbersIn(tex, runs);
    if (parts && check.keepsBackslashes(tex, 0, tex.size()))
        check.readFormula([&] { mathMlOf(maskedNumbers(tex, *parts, '1'), true); });
}

void checkPlain(const std::string& text, const TomlPosition& position, Complaints& complaints) {
    WordsCheck(position, complaints).isText(text);
}

void checkLine(const std::string& text, const TomlPosition& position, Complaints& complaints) {
    const std::size_t newline = text.find_first_of("\r\n");
    if (newline != std::string::npos)
        complaints.add(placeIn(position, newline), "a line break; this should be one line");
}

}  // namespace demos
