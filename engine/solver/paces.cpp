#include "engine/solver/paces.h"

namespace engine {
namespace {

int strideFor(int needed, bool looks, const Paces::Moment& moment) {
    const int whole = looks ? moment.aLook : moment.total;
    int stride = larger(smaller(moment.total / larger(needed, 1), whole), 1);
    while (whole % stride != 0 || moment.at % stride != 0) --stride;
    return stride;
}

}  // namespace

void connect(std::span<const Contact> contacts, std::span<const Joint> joints,
             const Bodies& bodies, DisjointSets& islands) {
    islands.reset(bodies.count(), bodies.active);
    const auto join = [&](int a, int b) {
        if (bodies.isAwake(a) && bodies.isAwake(b)) islands.join(a, b);
    };
    for (const Contact& contact : contacts) join(contact.a, contact.b);
    for (const Joint& joint : joints)
        if (joint.present) join(joint.def.a.index, joint.def.b.index);
}

void Paces::choose(DisjointSets& islands, const Substeps& substeps,
                   std::span<const Contact> contacts, std::span<const Joint> joints,
                   std::span<const char> everyStep, std::span<const char> looks, const Moment& moment,
                   Bodies& bodies) {
    islands_.resize(bodies.count());
    for (const int i : bodies.active) islands_[i] = {};
    for (const int i : bodies.active) {
        if (!bodies.isAwake(i)) continue;
        Island& island = islands_[islands.leaderOf(i)];
        island.substeps = larger(island.substeps, substeps.of(i));
        island.every = island.every || everyStep[i];
        island.looks = island.looks || looks[i];
    }
    const auto islandOf = [&](int a, int b) -> Island& {
        return islands_[islands.leaderOf(bodies.movable(a, b))];
    };
    for (const Contact& c : contacts)
        if (bodies.isDriven(c.a) || bodies.isDriven(c.b)) islandOf(c.a, c.b).every = true;
    for (const Joint& joint : joints) {
        if (!joint.present) continue;
        const int a = joint.def.a.index, b = joint.def.b.index;
        if (bodies.isAsleep(bodies.movable(a, b))) continue;
        if (bodies.isDriven(a) || bodies.isDriven(b)) islandOf(a, b).every = true;
    }
    for (const int i : bodies.active) {
        if (bodies.waits(i)) continue;
        bodies.strides[i] = 1;
        if (!bodies.isAwake(i)) continue;
        const Island& island = islands_[islands.leaderOf(i)];
        bodies.strides[i] = island.every ? 1 : strideFor(island.substeps, island.looks, moment);
    }
}

}  // namespace engine
