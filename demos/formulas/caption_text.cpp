#include "demos/formulas/caption_text.h"

#include <string_view>
#include <utility>

#include "demos/formulas/formula.h"
#include "demos/formulas/formula_layout.h"
#include "demos/formulas/formula_runs.h"
#include "demos/formulas/math_letters.h"
#include "demos/formulas/text_formulas.h"

namespace demos {
namespace {

constexpr std::pair<std::string_view, std::string_view> kRaised[] = {
    {"0", "⁰"}, {"1", "¹"}, {"2", "²"}, {"3", "³"}, {"4", "⁴"}, {"5", "⁵"}, {"6", "⁶"}, {"7", "⁷"},
    {"8", "⁸"}, {"9", "⁹"}, {"+", "⁺"}, {"−", "⁻"}, {"=", "⁼"}, {"(", "⁽"}, {")", "⁾"}, {"a", "ᵃ"},
    {"b", "ᵇ"}, {"c", "ᶜ"}, {"d", "ᵈ"}, {"i", "ⁱ"}, {"j", "ʲ"}, {"k", "ᵏ"}, {"m", "ᵐ"}, {"n", "ⁿ"},
    {"p", "ᵖ"}, {"t", "ᵗ"}, {"x", "ˣ"}, {"′", "′"}, {"∘", "°"}};
constexpr std::pair<std::string_view, std::string_view> kLowered[] = {
    {"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"}, {"5", "₅"}, {"6", "₆"}, {"7", "₇"},
    {"8", "₈"}, {"9", "₉"}, {"+", "₊"}, {"−", "₋"}, {"=", "₌"}, {"(", "₍"}, {")", "₎"}, {"a", "ₐ"},
    {"e", "ₑ"}, {"i", "ᵢ"}, {"j", "ⱼ"}, {"k", "ₖ"}, {"m", "ₘ"}, {"n", "ₙ"}, {"p", "ₚ"}, {"r", "ᵣ"},
    {"s", "ₛ"}, {"t", "ₜ"}, {"v", "ᵥ"}, {"x", "ₓ"}};

/// The run in raised or lowered letters; "^(a + b)" where Unicode lacks one.
std::string moved(const FormulaRun& run) {
    std::string result;
    bool whole = true;
    std::string_view rest = run.text;
    while (!rest.empty()) {
        std::string one;
        putCharacter(one, popCharacter(rest));
        std::string_view found;
        if (run.level > 0) {
            for (const auto& [letter, small] : kRaised)
                if (letter == one) found = small;
        } else {
            for (const auto& [letter, small] : kLowered)
                if (letter == one) found = small;
        }
        whole = whole && !found.empty();
        result += found;
    }
    if (whole) return result;
    std::string_view first = run.text;
    popCharacter(first);
    const std::string sign = run.level > 0 ? "^" : "_";
    return first.empty() ? sign + run.text : sign + "(" + run.text + ")";
}

std::string lettersOf(const std::string& mathMl) {
    std::string letters;
    FormulaRun joined;  // neighbours at one level
    const auto end = [&] { letters += joined.level == 0 ? joined.text : moved(joined); };
    for (const FormulaRun& run : formulaRuns(mathMl)) {
        if (run.level != joined.level) {
            end();
            joined = {};
        }
        joined.level = run.level;
        joined.text += run.text;
    }
    end();
    return letters;
}

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20; }

/// "\theta" in double quotes is a tab and "heta".
void checkBackslashes(const std::string& text, const ScannedText& scanned) {
    const auto refuse = [](std::size_t at) {
        throw FormulaError(at, "a tab, a line break or a control byte; write LaTeX on one line in single quotes, which "
                               "keep its backslashes");
    };
    for (const TextFormula& formula : scanned.formulas)
        for (std::size_t i = formula.begin; i < formula.end; ++i)
            if (isControl(text[i])) refuse(i);
    for (const std::size_t dollar : scanned.loose)
        if (dollar + 1 < text.size() && isControl(text[dollar + 1])) refuse(dollar + 1);
}

/// Throws FormulaError with the byte `at` of the text.
std::vector<render::Formula> layoutOf(const std::string& mathMl, std::size_t at) {
    try {
        return formulaLayout(mathMl);
    } catch (const FormulaError& error) {
        throw FormulaError(at + error.at(), error.what());
    }
}

/// \$ is a dollar.
std::string withoutEscapes(std::string text) {
    for (std::size_t at = text.find("\\$"); at != std::string::npos; at = text.find("\\$", at + 1)) text.erase(at, 1);
    return text;
}

}  // namespace

std::string formulaMark(std::size_t k) {
    std::string mark;
    putCharacter(mark, static_cast<char32_t>(render::kFirstFormula) + static_cast<char32_t>(k));
    return mark;
}

CaptionText captionText(const std::string& text) {
    const ScannedText scanned = scannedText(text);
    checkBackslashes(text, scanned);
    CaptionText result;
    std::size_t from = 0;
    const auto add = [&](const std::string& both) { result.letters += both, result.line += both; };
    for (const TextFormula& formula : scanned.formulas) {
        add(withoutEscapes(text.substr(from, formula.begin - from)));
        from = formula.end;
        const std::string mathMl = mathMlIn(formula);
        result.letters += lettersOf(mathMl);
        std::string markup = text.substr(formula.begin, formula.end - formula.begin);
        for (render::Formula& piece : layoutOf(mathMl, formula.at)) {
            if (result.formulas.size() == render::kMostFormulas)
                throw FormulaError(formula.begin, "more than " + std::to_string(render::kMostFormulas) +
                                                      " formulas and relations in a caption; write fewer");
            if (markup.empty()) result.line += ' ';
            result.line += formulaMark(result.formulas.size());
            result.markup.push_back(std::exchange(markup, {}));
            result.formulas.push_back(std::move(piece));
        }
    }
    add(withoutEscapes(text.substr(from)));
    return result;
}

}  // namespace demos
