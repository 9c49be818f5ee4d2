/// Which joints are solved together, and in which order they are eliminated.
///
/// The first forest takes every joint that closes no loop; the second takes what it can of the rest,
/// and so on: the first forest of a cloth are its columns, the second its rows. What even the last
/// one cannot take, and all soft joints, are left to the sweep. Where joints are torn there is no
/// exact solution, and a tree held twice would be thrown about in search of one: there what holds it a
/// second time is left to the next forest, and either takes back a part of what the other asks for.
///
/// In a forest joints of low degree go first, so that a chain costs time linear in its links and a
/// tree hardly more; of equal ones those whose turn could come soonest, so that a chain is eaten
/// from both ends and the processor works at two places at once.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/joint_constraint.h"

namespace engine {

struct ForestPlan {
    struct Link {
        int place;  // of a joint eliminated later
        int body;   // the movable body in common; -1: fill-in
    };
    struct Place {
        int joint = -1;           // in the constraint list
        int tree = -1;
        bool closes = false;      // holds its tree at a second fixed body
        std::vector<Link> later;  // ascending
    };
    struct Tree {
        int rows = 0;       // of its joint with the most
        bool whole = true;  // no rigid joint beside it: solved exactly as it stands
    };
    std::vector<Place> places;  // in order of elimination
    std::vector<Tree> trees;
};

/// Sets `inTree` of the joints that found a place.
std::vector<ForestPlan> planForests(std::span<JointConstraint> joints,
                                    std::span<const InverseMass> masses);

}  // namespace engine
