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

void Paces::link(DisjointSets& islands, const Links& links, const Bodies& bodies) {
    linked_.reset(bodies.count(), bodies.active);
    for (const int i : bodies.active)
        if (bodies.isAwake(i)) linked_.join(i, islands.leaderOf(i));
    const auto join = [&](int a, int b) {
        if (bodies.isMoving(a) && bodies.isMoving(b)) linked_.join(a, b);
    };
    for (const auto& [a, b] : links.forces) join(a, b);
    for (const Contact& c : links.contacts)
        if (bodies.isDriven(c.a) || bodies.isDriven(c.b)) join(c.a, c.b);
    for (const Joint& joint : links.joints) {
        const int a = joint.def.a.index, b = joint.def.b.index;
        if (joint.present && (bodies.isDriven(a) || bodies.isDriven(b))) join(a, b);
    }
}

void Paces::choose(const Substeps& substeps, std::span<const char> looks, const Moment& moment, Bodies& bodies) {
    sets_.resize(bodies.count());
    for (const int i : bodies.active) sets_[i] = {};
    for (const int i : bodies.active) {
        if (!bodies.isMoving(i)) continue;
        Set& set = sets_[linked_.leaderOf(i)];
        set.substeps = larger(set.substeps, substeps.of(i));
        set.looks = set.looks || looks[i];
    }
    for (const int i : bodies.active) {
        if (bodies.waits(i)) continue;
        const Set& set = sets_[linked_.leaderOf(i)];
        const bool chooses = !moment.every && bodies.isMoving(i);
        bodies.strides[i] = chooses ? strideFor(set.substeps, set.looks, moment) : 1;
    }
}

}  // namespace engine
