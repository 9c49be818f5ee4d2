/// Which joints are solved together, and in which order they are eliminated.
///
/// The first forest takes every joint that closes no loop, and the loops of rings and trusses, which have
/// few; the second takes what it can of the rest, and so on: for a cloth, the columns form the first forest,
/// the rows the second. Joints that even the last forest
/// cannot take, and all soft joints, are left to the sweep.
///
/// Where joints are torn, constraints cannot all hold, and there is no exact solution. A tree with few loops is
/// then damped (tree_part.h) and solved in several sweeps. With many, the joint that holds it a second time is
/// left to the next forest, and each forest undoes part of what the other does.
///
/// In a forest, joints of low degree are eliminated first, so a chain costs time linear in its links and a
/// tree hardly more. Among equals, those with the lowest level come first, so a chain is eliminated from both
/// ends and the processor can work on both in parallel.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/joint_constraint.h"

namespace engine {

struct ForestPlan {
    struct Link {
        int place;  // of a joint that is eliminated later
        int body;   // a common movable body; -1: fill-in
    };
    struct Place {
        int joint = -1;           // in the constraint list
        int tree = -1;
        bool closes = false;      // holds its tree at a second fixed body, or closes a loop
        bool gear = false;
        std::vector<Link> later;  // ascending
    };
    struct Tree {
        int rows = 0;       // of the joint with most rows
        bool whole = true;  // no rigid joint outside it acts on it: solved exactly
        bool closed = false;  // held twice, or with a loop of other joints than gears
        bool torn = false;    // a joint of its connected set is
        bool inNet = false;   // joints of its connected set are in several forests
    };
    std::vector<Place> places;  // one tree after the other, each in order of elimination
    std::vector<Tree> trees;
};

/// Sets `inTree` of the joints that are in a forest.
std::vector<ForestPlan> planForests(std::span<JointConstraint> joints,
                                    std::span<const InverseMass> masses);

}  // namespace engine
