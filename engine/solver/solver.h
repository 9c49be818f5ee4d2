/// What the solver of a world keeps from one sub-step to the next.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/solver/constraints.h"
#include "engine/solver/pressed_bodies.h"
#include "engine/wide/wide_contacts.h"

namespace engine {

struct Solver {
    Constraints constraints;
    Workers workers;
    WideContacts wide;               // the contacts instead, when they are solved in lanes
    bool lanes = false;              // they are
    JointTrees trees;
    PressedBodies pressed;
    DisjointSets islands;            // bodies that contacts and joints hold together
    std::vector<Pose> posesAtStart;  // of the step, where the contacts' rows were made
    std::vector<int> order;          // of the contacts, from the top down
    std::vector<std::uint64_t> keys; // of the contacts, while they are sorted
};

}  // namespace engine
