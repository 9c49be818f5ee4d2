/// Splits rows into independent problems: rows of different islands share no movable body, even
/// indirectly.
#pragma once
#include "engine/solver/global_rows.h"

namespace engine {

struct Island {
    GlobalRows rows;
    std::vector<int> places;  // indices of its rows in the whole list, ascending
};

/// Islands in the order of their first rows.
std::vector<Island> islandsOf(const GlobalRows& g, int bodies);

}  // namespace engine
