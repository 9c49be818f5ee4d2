#include "engine/wide/groups.h"

#include <algorithm>

namespace engine {
namespace {

constexpr double kFast = 0.5;         // m/s
constexpr int kFewContacts = 64;      // islands with fewer share a group

bool isFast(const Contact& contact, const Bodies& bodies) {
    const Vec3 passing =
        bodies.velocities[contact.b].linear - bodies.velocities[contact.a].linear;
    return passing.squaredNorm() > kFast * kFast;
}

}  // namespace

void ContactGroups::find(std::span<const Contact> contacts, std::span<const Joint> joints,
                         const Bodies& bodies, DisjointSets& islands) {
    islands_.resize(bodies.count());
    for (const int i : bodies.active) islands_[i] = {};
    jointed_ = false;
    for (const Joint& joint : joints) {
        if (!joint.present) continue;
        const int body = bodies.movable(joint.def.a.index, joint.def.b.index);
        if (!bodies.isAwake(body)) continue;
        islands_[islands.leaderOf(body)].jointed = true;
        jointed_ = true;
    }
    count(contacts, bodies, islands);
    number(contacts, bodies, islands);
}

void ContactGroups::count(std::span<const Contact> contacts, const Bodies& bodies,
                          DisjointSets& islands) {
    for (const Contact& contact : contacts) {
        Island& island = islands_[islands.leaderOf(bodies.movable(contact.a, contact.b))];
        ++island.contacts;
        island.fast += isFast(contact, bodies) ? 1 : 0;
    }
}

int ContactGroups::groupFor(const Island& island, double span) {
    if (island.jointed) return 0;
    const bool small = island.contacts < kFewContacts;
    if (!small) {
        moving_.push_back(50 * island.fast > island.contacts);
        return count() - 1;
    }
    const auto same = [&](const Open& open) { return open.span == span; };
    auto open = std::ranges::find_if(open_, same);
    if (open == open_.end()) open = open_.insert(open_.end(), {span, -1, 0});
    if (open->room <= 0) {
        *open = {span, count(), kFewContacts};
        moving_.push_back(0);
    }
    open->room -= island.contacts;
    return open->group;
}

void ContactGroups::number(std::span<const Contact> contacts, const Bodies& bodies,
                           DisjointSets& islands) {
    moving_.assign(jointed_ ? 1 : 0, 0);
    ofContact_.clear();
    open_.clear();
    for (const Contact& contact : contacts) {
        const int body = bodies.movable(contact.a, contact.b);
        Island& island = islands_[islands.leaderOf(body)];
        if (island.group < 0) island.group = groupFor(island, bodies.spans[body]);
        ofContact_.push_back(island.group);
    }
    jointedBodies_.clear();
    if (!jointed_) return;
    for (const int i : bodies.active) {
        if (!bodies.isDynamic(i)) continue;
        const Island& island = islands_[islands.leaderOf(i)];
        if (island.jointed && island.contacts > 0) jointedBodies_.push_back(i);
    }
}

}  // namespace engine
