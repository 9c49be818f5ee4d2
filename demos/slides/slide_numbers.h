/// Finds and replaces the numbers in a slide's words.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "demos/slides/deck.h"
#include "demos/slides/numbers.h"
#include "demos/slides/quantity.h"

namespace demos {

/// All @{...} of title, text, formulas, caption and notes. Throws NumberError.
std::vector<NumberName> numbersIn(const Slide& slide);

using NumberValue = std::function<std::string(const NumberName&, NumberSetting)>;

/// Replaces all @{...} by values; in formulas, also those between dollars in a text, as LaTeX. In a
/// text a value is never markup: it begins no list and ends no formula.
/// Throws NumberError, and what `value` throws.
void fillNumbers(Slide& slide, const NumberValue& value);

}  // namespace demos
