/// Which islands take part in a sub-step. A step of the world has as many sub-steps as the most demanding
/// island needs (substeps.h). An island that needs fewer takes part in every second, third, ... sub-step and
/// advances by that many at once:
///   stride = the largest divisor of the world's sub-steps that leaves the island the number it needs; if it looks
///            (world_looks.h), of those between two looks; within a step, also of those already done
/// So a fast wheel does not slow down a heap next to it. Islands whose bodies depend on each other, because of a force
/// or because the same moving kinematic body touches or holds them, share one stride, which is also that body's.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/solver/substeps.h"

namespace engine {

class Paces {
public:
    /// The moment of a choice: before sub-step `at` of `total`, with contact detection after every `aLook`.
    struct Moment {
        int at = 0, total = 1, aLook = 1;
        bool every = false;  // all take part in every sub-step
    };
    /// What depends on what.
    struct Links {
        std::span<const Contact> contacts;
        std::span<const Joint> joints;
        std::span<const std::pair<int, int>> forces;  // bodies whose forces depend on each other
    };

    /// Finds the sets of bodies that share a stride.
    void link(DisjointSets& islands, const Links& links, const Bodies& bodies);
    /// That of a body: one of its bodies.
    int setOf(int body) { return linked_.leaderOf(body); }
    /// Sets Bodies::strides of all that do not wait; those that wait keep theirs. `looks`: by body.
    void choose(const Substeps& substeps, std::span<const char> looks, const Moment& moment, Bodies& bodies);

private:
    struct Set {
        int substeps = 0;
        bool looks = false;
    };

    DisjointSets linked_;    // islands that share a stride
    std::vector<Set> sets_;  // by leader
};

/// Joins bodies that are connected by any chain of contacts and joints.
void connect(std::span<const Contact> contacts, std::span<const Joint> joints,
             const Bodies& bodies, DisjointSets& islands);

}  // namespace engine
