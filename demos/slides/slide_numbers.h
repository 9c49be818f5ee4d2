/// The places of a slide where numbers of its runs stand.
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

/// Puts values in place of them; within formulas, also those between dollars in a text, as LaTeX.
/// In a text they are words, wherever they stand: no list, no end of a formula.
/// Throws NumberError, and what `value` throws.
void fillNumbers(Slide& slide, const NumberValue& value);

}  // namespace demos
