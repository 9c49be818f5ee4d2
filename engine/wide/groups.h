/// Islands: bodies not connected by contacts and joints are independent problems, and each is swept as often
/// as it needs. Small islands with equal sub-steps (Bodies::spans) share a group, to fill the lanes. All
/// islands with joints are in the first group, because their trees are solved together.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/bodies.h"

namespace engine {

class ContactGroups {
public:
    /// Groups the contacts, with the present velocities; `islands`: the connected bodies.
    void find(std::span<const Contact> contacts, std::span<const Joint> joints,
              const Bodies& bodies, DisjointSets& islands);

    int count() const { return static_cast<int>(moving_.size()); }
    bool hasJoints() const { return jointed_; }  // in group 0
    int of(int contact) const { return ofContact_[contact]; }
    /// A large island where more than one in fifty contacts is between bodies that pass each other at more
    /// than 0.5 m/s: it does not need the sweeps that keep a heap at rest.
    bool moving(int group) const { return moving_[group] != 0; }
    /// Bodies of group 0 that contacts may move.
    std::span<const int> jointedBodies() const { return jointedBodies_; }

private:
    struct Island {
        int contacts = 0, fast = 0, group = -1;
        bool jointed = false;
    };

    /// A group that takes further small islands.
    struct Open {
        double span = 0.0;  // s, of its bodies
        int group = -1, room = 0;
    };

    void count(std::span<const Contact> contacts, const Bodies& bodies, DisjointSets& islands);
    void number(std::span<const Contact> contacts, const Bodies& bodies, DisjointSets& islands);
    int groupFor(const Island& island, double span);

    std::vector<Open> open_;
    std::vector<int> ofContact_, jointedBodies_;
    std::vector<Island> islands_;  // by leader
    std::vector<char> moving_;
    bool jointed_ = false;
};

}  // namespace engine
