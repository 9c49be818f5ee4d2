#include "engine/wide/groups.h"

namespace engine {
namespace {

constexpr double kFast = 0.5;         // m/s
constexpr int kFewContacts = 64;      // islands with fewer share a group

/// A body of the pair that impulses move.
int movable(const Bodies& bodies, int a, int b) { return bodies.isDynamic(a) ? a : b; }

bool isFast(const Contact& contact, const Bodies& bodies) {
    const Vec3 passing =
        bodies.velocities[contact.b].linear - bodies.velocities[contact.a].linear;
    return passing.squaredNorm() > kFast * kFast;
}

}  // namespace

void ContactGroups::find(std::span<const Contact> contacts, std::span<const Joint> joints,
                         const Bodies& bodies) {
    sets_.reset(bodies.count());
    for (const Contact& contact : contacts)
        if (bodies.isDynamic(contact.a) && bodies.isDynamic(contact.b))
            sets_.join(contact.a, contact.b);
    for (const Joint& joint : joints)
        if (joint.present && bodies.isDynamic(joint.def.a.index) &&
            bodies.isDynamic(joint.def.b.index))
            sets_.join(joint.def.a.index, joint.def.b.index);
    islands_.assign(bodies.count(), {});
    jointed_ = false;
    for (const Joint& joint : joints) {
        if (!joint.present) continue;
        islands_[sets_.leaderOf(movable(bodies, joint.def.a.index, joint.def.b.index))].jointed = true;
        jointed_ = true;
    }
    count(contacts, bodies);
    number(contacts, bodies);
}

void ContactGroups::count(std::span<const Contact> contacts, const Bodies& bodies) {
    for (const Contact& contact : contacts) {
        Island& island = islands_[sets_.leaderOf(movable(bodies, contact.a, contact.b))];
        ++island.contacts;
        island.fast += isFast(contact, bodies) ? 1 : 0;
    }
}

void ContactGroups::number(std::span<const Contact> contacts, const Bodies& bodies) {
    int open = -1, room = 0;  // the group that small islands go to, and how many contacts it takes
    moving_.assign(jointed_ ? 1 : 0, 0);
    ofContact_.clear();
    for (const Contact& contact : contacts) {
        Island& island = islands_[sets_.leaderOf(movable(bodies, contact.a, contact.b))];
        if (island.group < 0) {
            const bool small = island.contacts < kFewContacts;
            island.group = island.jointed ? 0 : small && room > 0 ? open : count();
            if (island.group == count())
                moving_.push_back(!small && 50 * island.fast > island.contacts);
            if (small && !island.jointed) {
                room = room > 0 ? room - island.contacts : kFewContacts - island.contacts;
                open = island.group;
            }
        }
        ofContact_.push_back(island.group);
    }
    jointedBodies_.clear();
    if (!jointed_) return;
    for (int i = 0; i < bodies.count(); ++i) {
        if (!bodies.isDynamic(i)) continue;
        const Island& island = islands_[sets_.leaderOf(i)];
        if (island.jointed && island.contacts > 0) jointedBodies_.push_back(i);
    }
}

}  // namespace engine
