#include "demos/slides/slide_numbers.h"

#include <algorithm>

#include "demos/formulas/text_formulas.h"

namespace demos {
namespace {

void addNumbers(const std::string& text, std::vector<NumberName>& names) {
    const NumberedText parts = numberedText(text);
    names.insert(names.end(), parts.numbers.begin(), parts.numbers.end());
}

/// Whether a value between these words would change their meaning in CommonMark: digits after a
/// dollar, which then closes nothing, a link's address after a bracket, the number of a list.
bool meansMore(const std::string& before, const std::string& value, const std::string& after) {
    if (before.ends_with('$') || before.ends_with(']')) return true;
    const std::size_t line = before.rfind('\n') + 1;  // npos + 1 is 0
    return (after.starts_with('.') || after.starts_with(')')) &&
           value.find_first_not_of("0123456789") == std::string::npos &&
           before.find_first_not_of(" \t>*+-.)0123456789", line) == std::string::npos;
}

/// Writes the first sign as an entity, which is never markup.
std::string harmless(const std::string& value) {
    const auto first = static_cast<unsigned char>(value.empty() ? 0x80 : value.front());
    return first >= 0x80 ? value : "&#" + std::to_string(first) + ";" + value.substr(1);
}

template <class Span>
bool isWithin(std::size_t place, const std::vector<Span>& spans) {
    return std::any_of(spans.begin(), spans.end(),
                       [&](const Span& span) { return span.begin < place && place < span.end; });
}

std::string filledFormula(const std::string& tex, const NumberValue& value) {
    const NumberedText parts = numberedText(tex);
    std::string result = parts.words.front();
    for (std::size_t i = 0; i < parts.numbers.size(); ++i)
        result += value(parts.numbers[i], NumberSetting::formula) + parts.words[i + 1];
    return result;
}

std::string filledWords(const std::string& text, const NumberValue& value) {
    const NumberedText parts = numberedText(text);
    const ScannedText scanned = scannedText(maskedNumbers(text, parts, 'x'));
    std::string result = parts.words.front();
    for (std::size_t i = 0; i < parts.numbers.size(); ++i) {
        const bool formula = isWithin(parts.places[i], scanned.formulas);
        const std::string shown =
            value(parts.numbers[i], formula ? NumberSetting::formula : NumberSetting::text);
        const std::string& after = parts.words[i + 1];
        const bool plain = formula || isWithin(parts.places[i], scanned.code);
        result += (plain || !meansMore(result, shown, after) ? shown : harmless(shown)) + after;
    }
    return result;
}

}  // namespace

std::vector<NumberName> numbersIn(const Slide& slide) {
    std::vector<NumberName> names;
    for (const std::string* text : {&slide.title, &slide.text, &slide.caption, &slide.notes})
        addNumbers(*text, names);
    for (const std::string& formula : slide.formulas) addNumbers(formula, names);
    return names;
}

void fillNumbers(Slide& slide, const NumberValue& value) {
    for (std::string* text : {&slide.title, &slide.text, &slide.caption, &slide.notes})
        *text = filledWords(*text, value);
    for (std::string& formula : slide.formulas) formula = filledFormula(formula, value);
}

}  // namespace demos
