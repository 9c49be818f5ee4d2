/// How tall the columns are: bodies that stand on each other, counted from the floor up, where an
/// island has fewer than four of them on a level. A column sways as a whole, the softer the taller it
/// is; wide heaps brace themselves.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/dynamics/bodies.h"

namespace engine {

class Columns {
public:
    void measure(std::span<const Contact> contacts, const Bodies& bodies, DisjointSets& islands);
    /// Levels of an island, by its leader; 0: it is no column.
    int tallest(int leader) const { return tallest_[leader]; }

private:
    std::vector<int> tallest_, sizes_;  // of an island, at its leader; bodies that contacts touch
    std::vector<int> levels_;           // of every body
    std::vector<int> narrow_;           // contacts of islands that may be columns
};

}  // namespace engine
