/// How many sub-steps what stands on the floor asks for, of the levels n of bodies on each other. A
/// structure sways as a whole, the softer the taller it is, and only shorter sub-steps hold it:
///   column  fewer than four bodies on a level      2 n / 5 - 2         a stack of 20 asks for six
///   wall    as wide as it likes                    c^2 / (5 n)         20 rows for four
/// where c = bodies / bodies on the floor is what the lowest of them carry: n of a wall, n / 2 of a
/// pyramid (45 rows ask for 2.4), little of a heap, which braces itself.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/dynamics/bodies.h"

namespace engine {

class Columns {
public:
    /// `order`: the contacts from the top down.
    void measure(std::span<const Contact> contacts, std::span<const int> order, const Bodies& bodies,
                 DisjointSets& islands);
    /// Of an island, by its leader; 0: nothing stands there.
    double substeps(int leader) const;
    /// Of a column; 0: it is none.
    int levels(int leader) const;

private:
    struct Island {
        int bodies = 0, onTheFloor = 0, levels = 0;
    };

    void number(std::span<const Contact> contacts, std::span<const int> order,
                const Bodies& bodies);

    std::vector<Island> islands_;  // by leader
    std::vector<int> levels_;      // of every body
};

}  // namespace engine
