/// The input and output of the solver: the black box of the first seed. Bodies are an array of velocities,
/// and constraints refer to them by number; shapes are unknown here.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact_constraint.h"
#include "engine/constraints/drive.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/settings.h"
#include "engine/base/by_group.h"
#include "engine/solver/impacts.h"
#include "engine/solver/joint_trees.h"
#include "engine/solver/riding_contacts.h"
#include "engine/step_report.h"

namespace engine {

struct Constraints {
    std::vector<ContactConstraint> contacts;
    std::vector<JointConstraint> joints;
    std::vector<JointDrive> drives;  // of joints with limits, motors, springs or rotors
    std::vector<int> order;  // order of the contacts in a sweep
    ByGroup jointsByGroup;   // wide/groups.h
    ByGroup jointsOutside;   // those outside the trees
    ByGroup drivesByGroup;
    Impacts impacts;         // of contacts with restitution
    RidingContacts riding;   // on bodies that turn
    bool ratesStale = true;  // velocities changed since the last solve (keepRates in drives.h)
};

/// One solve is enough for the joints, if no contacts are on them: there are only trees.
inline bool solvedAtOnce(const Constraints& c, const JointTrees& trees) {
    return c.drives.empty() && !trees.empty() && trees.isExact(0) &&
           trees.order().size() == c.joints.size();
}

}  // namespace engine
