/// How tall the tallest column is: bodies that stand on each other, counted from the floor up, where an
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
    /// Levels; 0: there is none.
    int tallest(std::span<const Contact> contacts, const Bodies& bodies);

private:
    DisjointSets islands_;
    std::vector<int> sizes_;   // bodies of an island, at its leader
    std::vector<int> levels_;  // of every body
    std::vector<int> narrow_;  // contacts of islands that may be columns
};

}  // namespace engine
