#include "engine/wide/groups.h"

#include <algorithm>

namespace engine {
namespace {

constexpr double kFast = 0.5;         // m/s
constexpr double kCalm = 0.25;        // m/s: a house of cards that loses its balance is slower at first
constexpr int kManyContacts = 1024;   // of an island, whose rest would be too expensive
constexpr int kFewContacts = 64;      // islands with fewer share a group
constexpr int kFewOfJointed = 16;     // the same for those with joints

/// m^2/s^2
double passingSquared(const Contact& contact, const Bodies& bodies) {
    return (bodies.velocities[contact.b].linear - bodies.velocities[contact.a].linear).squaredNorm();
}

}  // namespace

void ContactGroups::find(std::span<const Contact> contacts, std::span<const Joint> joints,
                         const Bodies& bodies, DisjointSets& islands) {
    islands_.resize(bodies.count());
    for (const int i : bodies.active) islands_[i] = {};
    count(contacts, bodies, islands);
    moving_.clear(), touched_.clear(), atRest_.clear(), spans_.clear(), bodies_.clear(), open_.clear();
    thinness_.clear(), counts_.clear();
    const auto eachAwake = [&](const auto& visit) {
        for (const Joint& joint : joints) {
            const int body = bodies.movable(joint.def.a.index, joint.def.b.index);
            if (joint.present && bodies.isAwake(body)) visit(joint, body, islands_[islands.leaderOf(body)]);
        }
    };
    eachAwake([](const Joint& joint, int, Island& island) {
        island.jointed = true;
        island.driven = island.driven || joint.acts;
        island.swept = island.swept || !joint.solvedAtOnce;
    });
    eachAwake([&](const Joint&, int body, Island& island) {
        if (island.group < 0) island.group = groupFor(island, body, bodies.spans[body]);
    });
    jointed_ = count();
    std::ranges::fill(atRest_, 0);
    open_.clear();
    ofContact_.clear(), islandOfContact_.clear();
    for (const Contact& contact : contacts) {
        const int body = bodies.movable(contact.a, contact.b);
        const int leader = islands.leaderOf(body);
        Island& island = islands_[leader];
        islandOfContact_.push_back(leader);
        if (island.group < 0) island.group = groupFor(island, body, bodies.spans[body]);
        if (!island.calm || island.contacts >= kManyContacts) atRest_[island.group] = 0;
        ofContact_.push_back(island.group);
        thinness_[island.group] += 1.0 / bodies.thinner(contact.a, contact.b), ++counts_[island.group];
    }
    findJointedBodies(contacts, bodies, islands);
}

void ContactGroups::count(std::span<const Contact> contacts, const Bodies& bodies,
                          DisjointSets& islands) {
    for (const Contact& contact : contacts) {
        Island& island = islands_[islands.leaderOf(bodies.movable(contact.a, contact.b))];
        ++island.contacts;
        const double passing = passingSquared(contact, bodies);
        island.fast += passing > kFast * kFast ? 1 : 0;
        island.calm = island.calm && passing <= kCalm * kCalm;
    }
}

int ContactGroups::addGroup(bool moving, bool touched, int body, double span) {
    moving_.push_back(moving);
    touched_.push_back(touched);
    atRest_.push_back(1);
    spans_.push_back(span);
    bodies_.push_back(body);
    thinness_.push_back(0.0), counts_.push_back(0);
    return count() - 1;
}

int ContactGroups::groupFor(const Island& island, int body, double span) {
    const bool touched = island.contacts > 0;
    const int few = island.jointed ? kFewOfJointed : kFewContacts;
    if (island.contacts >= few || island.swept)
        return addGroup(!island.jointed && 50 * island.fast > island.contacts, touched, body, span);
    const auto same = [&](const Open& open) {
        return open.span == span && open.driven == island.driven && touched_[open.group] == touched;
    };
    auto open = std::ranges::find_if(open_, same);
    if (open == open_.end())
        open = open_.insert(open_.end(), {span, island.driven, addGroup(false, touched, body, span), few});
    else if (open->room <= 0)
        *open = {span, island.driven, addGroup(false, touched, body, span), few};
    open->room -= island.contacts;
    return open->group;
}

void ContactGroups::findJointedBodies(std::span<const Contact> contacts, const Bodies& bodies,
                                      DisjointSets& islands) {
    candidates_.clear(), jointedBodies_.clear();
    const auto islandOf = [&](int body) -> const Island& {
        return islands_[islands.leaderOf(body)];
    };
    if (jointed_ > 0) {
        touches_.resize(bodies.count());
        for (const int i : bodies.active) touches_[i] = 0;
        for (const Contact& contact : contacts) touches_[contact.a] = touches_[contact.b] = 1;
        for (const int i : bodies.active)
            if (touches_[i] && bodies.isDynamic(i) && islandOf(i).jointed) candidates_.push_back(i);
    }
    byGroup_.sort(static_cast<int>(candidates_.size()), jointed_,
                  [&](int k) { return islandOf(candidates_[k]).group; });
    firstBody_.assign(1, 0);
    for (int g = 0; g < jointed_; ++g) {
        for (const int k : byGroup_.of(g)) jointedBodies_.push_back(candidates_[k]);
        firstBody_.push_back(static_cast<int>(jointedBodies_.size()));
    }
}

int ContactGroups::ofJoint(int a, int b, const Bodies& bodies, DisjointSets& islands) const {
    const int body = bodies.movable(a, b);
    return bodies.isAwake(body) ? islands_[islands.leaderOf(body)].group : -1;
}

}  // namespace engine
