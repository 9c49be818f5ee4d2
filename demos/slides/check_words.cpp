#include "demos/slides/check_words.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "demos/scene/nearest.h"
#include "demos/slides/formula.h"
#include "demos/slides/numbers.h"
#include "demos/slides/text_formulas.h"

namespace demos {
namespace {

/// Names of the things of a kind, for "is there one": bodies, joints.
template <class Thing>
std::vector<std::string> namesOf(const std::vector<Thing>& things) {
    std::vector<std::string> names;
    for (const Thing& thing : things) names.push_back(thing.name);
    return names;
}

/// Why the run has no body or joint of the name; empty where it has.
std::string whyNone(const char* kind, const std::string& name,
                    const std::vector<std::string>& names, const std::string& scene) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return "";
    return "no " + std::string(kind) + " of '" + scene + "' is called '" + shown(name) + "'" +
           suggestion(name, names);
}

std::string whyNoExpectation(const NumberName& name, const SceneDescription& scene) {
    std::size_t number = 0;
    std::from_chars(name.of.data(), name.of.data() + name.of.size(), number);
    const std::size_t count = scene.expectations.size();
    if (number <= count) return "";
    return "'" + scene.name + "' has " + std::to_string(count) +
           " [[expect]]; there is no expectation " + name.of;
}

/// Why no run gives this number; empty where one does.
std::string whyNoNumber(const NumberName& name, const std::vector<SceneDescription>& runs) {
    if (runs.empty()) return "nothing is played here that has numbers; name a scene";
    if (name.run > static_cast<int>(runs.size()))
        return "there is no run " + std::to_string(name.run) + "; the slide has " +
               std::to_string(runs.size());
    const SceneDescription& scene = runs[static_cast<std::size_t>(name.run) - 1];
    if (name.group == "body") return whyNone("body", name.of, namesOf(scene.bodies), scene.name);
    if (name.group == "joint") return whyNone("joint", name.of, namesOf(scene.joints), scene.name);
    return name.group == "expect" ? whyNoExpectation(name, scene) : "";
}

class WordsCheck {
public:
    WordsCheck(const Written& written, Complaints& complaints)
        : written_(written), complaints_(complaints) {}

    void complain(std::size_t byte, const std::string& what) {
        complaints_.add(placeIn(written_, byte), what);
    }

    bool isText(const std::string& text) {
        if (text.size() > kMostWords) {
            complain(0, "the text has " + std::to_string(text.size()) +
                            " bytes; it should have at most " + std::to_string(kMostWords));
            return false;
        }
        const auto control = std::find_if(text.begin(), text.end(), [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return (byte < 0x20 && c != '\n' && c != '\t' && c != '\r') || byte == 0x7f;
        });
        if (control == text.end()) return true;
        complain(static_cast<std::size_t>(control - text.begin()), "a control byte; take it out");
        return false;
    }

    /// The text with digits in place of its numbers, byte for byte; nothing after a complaint.
    std::optional<std::string> withDigits(const std::string& text,
                                          const std::vector<SceneDescription>& runs) {
        NumberedText parts;
        try {
            parts = numberedText(text);
        } catch (const NumberError& error) {
            complain(error.at(), error.what());
            return std::nullopt;
        }
        std::string result = text;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < parts.numbers.size(); ++i) {
            const std::string why = whyNoNumber(parts.numbers[i], runs);
            if (!why.empty()) complain(parts.places[i], why);
            begin = parts.places[i];
            const std::size_t next =
                i + 1 < parts.places.size() ? parts.places[i + 1] : text.size();
            const std::size_t end = next - parts.words[i + 1].size();
            std::fill(result.begin() + static_cast<std::ptrdiff_t>(begin),
                      result.begin() + static_cast<std::ptrdiff_t>(end), '1');
        }
        return result;
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
    const Written& written_;
    Complaints& complaints_;
};

}  // namespace

void checkWords(const std::string& words, const Written& written,
                const std::vector<SceneDescription>& runs, Complaints& complaints) {
    WordsCheck check(written, complaints);
    if (!check.isText(words)) return;
    const std::optional<std::string> text = check.withDigits(words, runs);
    if (!text) return;
    for (const TextFormula& formula : formulasIn(*text))
        check.readFormula([&] { mathMlIn(formula); });
}

void checkFormula(const std::string& tex, const Written& written,
                  const std::vector<SceneDescription>& runs, Complaints& complaints) {
    WordsCheck check(written, complaints);
    if (!check.isText(tex)) return;
    if (const std::optional<std::string> text = check.withDigits(tex, runs))
        check.readFormula([&] { mathMlOf(*text, true); });
}

void checkPlain(const std::string& text, const Written& written, Complaints& complaints) {
    WordsCheck(written, complaints).isText(text);
}

}  // namespace demos
