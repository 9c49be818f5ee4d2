/// Whose turn it is. A step of the world is cut into the most sub-steps that any island asks for
/// (substeps.h); an island that asks for fewer takes part in every second, third or further one, and
/// goes on by as much at once:
///   stride = the largest divisor of the sub-steps between two looks for contacts that leaves the
///            island the number it asked for
/// So a wheel that turns fast costs nothing to the heap beside it. Whatever depends on what moves in
/// every sub-step moves with it: bodies that a force acts on, and islands that a moving kinematic body
/// touches or holds. Islands with joints keep one pace, because their trees are solved together.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/solver/substeps.h"

namespace engine {

class Paces {
public:
    /// Bodies::strides, of `total` sub-steps with a look after every `aLook` of them; all islands are at the
    /// same time. `everyStep`: bodies with stride 1.
    void choose(DisjointSets& islands, const Substeps& substeps, std::span<const Contact> contacts,
                std::span<const Joint> joints, std::span<const char> everyStep, int total, int aLook,
                Bodies& bodies);

    int longest() const { return longest_; }
    int ofJoints() const { return ofJoints_; }

private:
    struct Island {
        int substeps = 0;
        bool every = false, jointed = false;
    };

    std::vector<Island> islands_;  // by leader
    int longest_ = 1, ofJoints_ = 1;
};

/// Bodies that any chain of contacts and joints connects.
void connect(std::span<const Contact> contacts, std::span<const Joint> joints,
             const Bodies& bodies, DisjointSets& islands);

}  // namespace engine
