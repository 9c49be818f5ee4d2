#include "demos/slides/slide_numbers.h"

#include <algorithm>

#include "demos/slides/text_formulas.h"

namespace demos {
namespace {

void addNumbers(const std::string& text, std::vector<NumberName>& names) {
    const NumberedText parts = numberedText(text);
    names.insert(names.end(), parts.numbers.begin(), parts.numbers.end());
}

/// `setting`: of the byte where a number stands.
std::string filled(const std::string& text, const NumberValue& value,
                   const std::function<NumberSetting(std::size_t)>& setting) {
    const NumberedText parts = numberedText(text);
    std::string result = parts.words.front();
    for (std::size_t i = 0; i < parts.numbers.size(); ++i)
        result += value(parts.numbers[i], setting(parts.places[i])) + parts.words[i + 1];
    return result;
}

std::string filledWords(const std::string& text, const NumberValue& value) {
    const std::vector<TextFormula> formulas = formulasIn(text);
    return filled(text, value, [&](std::size_t place) {
        const bool within =
            std::any_of(formulas.begin(), formulas.end(), [&](const TextFormula& formula) {
                return formula.begin < place && place < formula.end;
            });
        return within ? NumberSetting::formula : NumberSetting::text;
    });
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
    for (std::string& formula : slide.formulas)
        formula = filled(formula, value, [](std::size_t) { return NumberSetting::formula; });
}

}  // namespace demos
