/// Which columns of a table hold numbers and are right-aligned.
#pragma once
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// One value per column of the head. A cell "-" means that there is no number.
std::vector<bool> numberColumns(const MadeTable& table);

}  // namespace demos
