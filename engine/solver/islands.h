/// Rows that share no movable body, however indirectly, are problems of their own.
#pragma once
#include "engine/solver/global_rows.h"

namespace engine {

struct Island {
    GlobalRows rows;
    std::vector<int> places;  // of its rows in the whole list, ascending
};

/// In the order of their first rows.
std::vector<Island> islandsOf(const GlobalRows& g, int bodies);

}  // namespace engine
