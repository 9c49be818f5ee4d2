/// Islands: bodies not connected by contacts and joints are independent problems, and each is swept as often
/// as it needs. Small islands with equal sub-steps (Bodies::spans) share a group, to fill the lanes. Islands
/// with joints are in groups of their own, the first ones; those that nothing touches share one, if their trees are
/// solved at once, and another one if limits, motors or springs act on them.
#pragma once
#include <span>
#include <vector>

#include "engine/base/disjoint_sets.h"
#include "engine/constraints/contact.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/bodies.h"
#include "engine/base/by_group.h"

namespace engine {

class ContactGroups {
public:
    /// Groups the contacts, with the present velocities; `islands`: the connected bodies.
    void find(std::span<const Contact> contacts, std::span<const Joint> joints,
              const Bodies& bodies, DisjointSets& islands);

    int count() const { return static_cast<int>(moving_.size()); }
    bool hasJoints(int group) const { return group < jointed_; }
    bool isTouched(int group) const { return touched_[group] != 0; }
    int of(int contact) const { return ofContact_[contact]; }
    /// The island of a contact: one of its bodies, the same for all.
    int islandOf(int contact) const { return islandOfContact_[contact]; }
    /// That of a joint between two bodies; -1 if they are asleep or cannot move.
    int ofJoint(int a, int b, const Bodies& bodies, DisjointSets& islands) const;
    /// A large island where more than one in fifty contacts is between bodies that pass each other at more
    /// than 0.5 m/s: it does not need the sweeps that keep a heap at rest.
    bool moving(int group) const { return moving_[group] != 0; }
    /// Islands of fewer than 1024 contacts and without joints where no two bodies pass each other at
    /// more than 0.25 m/s.
    bool atRest(int group) const { return atRest_[group] != 0; }
    /// s: the sub-step of its bodies.
    double span(int group) const { return spans_[group]; }
    /// m: the harmonic mean, over its contacts, of the thinner body's thickness.
    double thickness(int group) const { return counts_[group] / thinness_[group]; }
    /// One of them.
    int bodyOf(int group) const { return bodies_[group]; }
    /// Bodies with contacts that are connected with joints, directly or not; all or those of a group.
    std::span<const int> jointedBodies() const { return jointedBodies_; }
    std::span<const int> jointedBodies(int group) const {
        return jointedBodies().subspan(firstBody_[group], firstBody_[group + 1] - firstBody_[group]);
    }

private:
    struct Island {
        int contacts = 0, fast = 0, group = -1;
        bool jointed = false, driven = false, swept = false, calm = true;
    };

    /// A group that takes further small islands.
    struct Open {
        double span = 0.0;  // s, of its bodies
        bool driven = false;
        int group = -1;
        int room = 0;       // contacts
    };

    void count(std::span<const Contact> contacts, const Bodies& bodies, DisjointSets& islands);
    int groupFor(const Island& island, int body, double span);
    int addGroup(bool moving, bool touched, int body, double span);
    void findJointedBodies(std::span<const Contact> contacts, const Bodies& bodies,
                           DisjointSets& islands);

    std::vector<Open> open_;
    std::vector<int> ofContact_, islandOfContact_;
    std::vector<int> candidates_, jointedBodies_, firstBody_;  // the latter by group, and the end
    ByGroup byGroup_;
    std::vector<Island> islands_;  // by leader
    std::vector<char> touches_;                    // by body
    std::vector<char> moving_, touched_, atRest_;  // by group
    std::vector<double> spans_, thinness_;  // the latter: the sum of 1 / thickness
    std::vector<int> counts_;               // contacts
    std::vector<int> bodies_;
    int jointed_ = 0;                     // groups
};

}  // namespace engine
