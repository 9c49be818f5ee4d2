/// Which columns of a table hold numbers and stand right-aligned.
#pragma once
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// For every column of the head. A dash alone says that there is no number.
std::vector<bool> numberColumns(const MadeTable& table);

}  // namespace demos
