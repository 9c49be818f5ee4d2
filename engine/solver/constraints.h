/// What goes into the solver and comes out of it: the black box of the first seed. Bodies are an
/// array of velocities; constraints name them by number; nothing here knows a shape.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact_constraint.h"
#include "engine/constraints/drive.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/settings.h"
#include "engine/solver/impacts.h"
#include "engine/solver/joint_trees.h"
#include "engine/step_report.h"

namespace engine {

struct Constraints {
    std::vector<ContactConstraint> contacts;
    std::vector<JointConstraint> joints;
    std::vector<JointDrive> drives;  // of joints that are limited, driven or sprung, or turn a rotor
    std::vector<int> order;  // of the contacts in a sweep
    Impacts impacts;         // of contacts with restitution
    int jointStride = 1;     // sub-steps of the world's that joints go on by at once; 0: they wait
    bool ratesStale = true;  // velocities are not those of the last solve (keepRates in drives.h)
};

/// One solve is enough: there is nothing but trees.
inline bool solvedAtOnce(const Constraints& c, const JointTrees& trees) {
    return c.contacts.empty() && c.drives.empty() && !trees.empty() && trees.exact() &&
           trees.order().size() == c.joints.size();
}

}  // namespace engine
