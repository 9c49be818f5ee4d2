/// The state of a world's solver between sub-steps.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/solver/conjugate_joints.h"
#include "engine/solver/constraints.h"
#include "engine/solver/fresh_start.h"
#include "engine/solver/joined_start.h"
#include "engine/solver/pressed_bodies.h"
#include "engine/solver/tree_drives.h"
#include "engine/wide/wide_contacts.h"

namespace engine {

/// Joints that act in a sub-step: a group of islands that is solved by itself, or all.
struct JointGroup {
    int number = 0;
    int stride = 1;  // of its bodies, in sub-steps of the world
    bool pushed = false;  // by contacts that were nudged
};

struct Solver {
    Constraints constraints;
    Workers workers;
    bool byIsland = false;           // islands are solved one after the other, in groups
    ContactGroups groups;            // if so
    bool lanes = false;              // and their contacts in lanes:
    WideContacts wide;
    std::vector<int> firstOfGroup;   // otherwise in constraints.order, by group; and the end
    std::vector<JointGroup> actingJoints;
    std::vector<char> pushed;        // by body: nudged by a contact; only of jointedBodies()
    JointTrees trees;
    TreeDrives treeDrives;           // limits, motors and springs of joints in trees
    ConjugateJoints conjugate;       // while a group is solved
    FreshStart fresh;                // of contacts that are not in lanes
    JoinedStart joined;              // of islands with joints
    PressedBodies pressed;
    DisjointSets islands;            // bodies connected by contacts and joints
    std::vector<Pose> posesAtStart;  // of the step, where the contacts' rows were made
    std::vector<Velocity> velocitiesAtStart;
    std::vector<int> order;          // of the contacts, from the top down
    std::vector<std::uint64_t> keys; // of the contacts, while they are sorted
};

}  // namespace engine
