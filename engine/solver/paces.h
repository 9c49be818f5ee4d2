/// Which islands take part in a sub-step. A step of the world has as many sub-steps as the most demanding
/// island needs (substeps.h). An island that needs fewer takes part in every second, third, ... sub-step and
/// advances by that many at once:
///   stride = the largest divisor of the world's sub-steps that leaves the island the number it needs; if it looks
///            (world_looks.h), of those between two looks; within a step, also of those already done
/// So a fast wheel does not slow down a heap next to it. Bodies that a force acts on, and islands that a
/// moving kinematic body touches or holds, take part in every sub-step.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/solver/substeps.h"

namespace engine {

class Paces {
public:
    /// The moment of a choice: before sub-step `at` of `total`, with contact detection after every `aLook`.
    struct Moment {
        int at = 0, total = 1, aLook = 1;
    };

    /// Sets Bodies::strides of all that do not wait; those that wait keep theirs. `everyStep`: bodies with
    /// stride 1; `looks`: those that look.
    void choose(DisjointSets& islands, const Substeps& substeps, std::span<const Contact> contacts,
                std::span<const Joint> joints, std::span<const char> everyStep, std::span<const char> looks,
                const Moment& moment, Bodies& bodies);

private:
    struct Island {
        int substeps = 0;
        bool every = false, looks = false;
    };

    std::vector<Island> islands_;  // by leader
};

/// Joins bodies that are connected by any chain of contacts and joints.
void connect(std::span<const Contact> contacts, std::span<const Joint> joints,
             const Bodies& bodies, DisjointSets& islands);

}  // namespace engine
