/// The number of sub-steps that a structure on the floor needs, from its levels n of stacked bodies. A
/// structure sways as a whole, the more the taller it is, and only shorter sub-steps prevent that:
///   column  fewer than four bodies per level       2 n / 5 - 2         a stack of 20 needs six
///   wall    wider                                  c^2 / (5 n)         20 rows need four
/// where c = bodies / bodies on the floor is the load on the lowest ones: n for a wall, n / 2 for a pyramid
/// (45 rows need 2.4), little for a heap, which supports itself sideways. That is for bodies of half a
/// metre or more. Smaller ones sway faster, at a rate of sqrt(g / s), s the side of a cube that reaches as far as the
/// mean body. With w = sqrt(0.5 m / s), at least 1, a wall gets w times as many and a column
///   w (2 n / 5 - 1.3) - 0.7
/// Even five dice of 5 mm fall with four; ten of 5 cm get eight, ten of 1 cm 19 before rounding up.
/// Contacts wider than half the thinner body are left out, because what is thinner than the margin of contact
/// detection has contacts with many of its neighbours, through those between.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/dynamics/bodies.h"
#include "engine/wide/schedule.h"

namespace engine {

class Columns {
public:
    /// `order`: the contacts from the top down.
    void measure(std::span<const Contact> contacts, std::span<const int> order, const Bodies& bodies,
                 DisjointSets& islands);
    /// For an island, given by its leader; 0: no structure.
    double substeps(int leader) const { return islands_[leader].substeps; }
    /// The levels of a column; 0: not a column.
    int levels(int leader) const;

private:
    struct Island {
        int bodies = 0, onTheFloor = 0, levels = 0;
        double reach = 0.0;  // m, of all bodies together
        double substeps = 0.0;
    };

    /// Lists the contacts that bear, in this order.
    void findBearing(std::span<const Contact> contacts, std::span<const int> order,
                     const Bodies& bodies);
    void number(const Bodies& bodies);
    static int levelsOf(const Island& island);
    static double substepsOf(const Island& island);

    std::vector<Island> islands_;  // by leader
    std::vector<int> levels_;      // by body
    std::vector<BodyPair> bearing_;
};

}  // namespace engine
