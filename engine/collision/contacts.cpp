#include "engine/collision/contacts.h"

#include <algorithm>

#include "engine/collision/collide.h"

namespace engine {
namespace {

constexpr double kSamePlace = 0.02;  // m

Contact contactOf(const Bodies& bodies, const PairKey& pair, const Manifold& manifold) {
    const Material &a = bodies.defs[pair.a].material, &b = bodies.defs[pair.b].material;
    Contact contact;
    contact.a = pair.a, contact.b = pair.b;
    contact.normal = manifold.normal;
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.restitution = larger(a.restitution, b.restitution);
    contact.count = manifold.count;
    for (int i = 0; i < manifold.count; ++i) {
        const ManifoldPoint& point = manifold.points[i];
        contact.points[i].anchorA = bodies.poses[pair.a].toLocal(point.onA);
        contact.points[i].anchorB = bodies.poses[pair.b].toLocal(point.onB);
        contact.points[i].feature = point.feature;
    }
    return contact;
}

/// Near: within the margin, or as far as this step's hits may throw the two. Up to two contacts.
void addContacts(const Bodies& bodies, const PairKey& pair, double margin, double near, double dt,
                 ContactFinder& finder) {
    if (const std::optional<Impact> impact =
            impactOf(bodies, pair, finder.moving, near > margin, dt)) {
        const MovingManifolds found =
            collideMoving(bodies, pair, finder.moving, *impact, margin, near, dt);
        for (int i = 0; i < found.count; ++i)
            finder.contacts.push_back(contactOf(bodies, pair, found.manifolds[i]));
        return;
    }
    const Manifold manifold =
        collide(bodies.defs[pair.a].shape, bodies.poses[pair.a], bodies.defs[pair.b].shape,
                bodies.poses[pair.b], margin);
    if (manifold.count > 0) finder.contacts.push_back(contactOf(bodies, pair, manifold));
}

}  // namespace

void carryImpulses(const Contact& from, Contact& to) {
    to.depth = from.depth;
    bool taken[Contact::kMaxPoints] = {}, found[Contact::kMaxPoints] = {};
    const auto carry = [&](int i, int j) {
        to.points[i].impulse = from.points[j].impulse;
        to.points[i].friction = from.points[j].friction;
        found[i] = taken[j] = true;
    };
    for (int i = 0; i < to.count; ++i)
        for (int j = 0; j < from.count; ++j)
            if (!taken[j] && to.points[i].feature == from.points[j].feature) {
                carry(i, j);
                break;
            }
    // What has another name in the same place (the reference face has changed sides, say).
    for (int i = 0; i < to.count; ++i)
        for (int j = 0; j < from.count && !found[i]; ++j)
            if (!taken[j] && (to.points[i].anchorA - from.points[j].anchorA).squaredNorm() <
                                 kSamePlace * kSamePlace)
                carry(i, j);
}

void findContacts(const Bodies& bodies, ContactFinder& finder, double margin, double dt) {
    finder.broadPhase.update(bodies, margin, dt);
    findImpacts(bodies, finder.broadPhase, finder.jointed, margin, dt, finder.moving);
    finder.contacts.swap(finder.previous);
    finder.contacts.clear();
    auto old = finder.previous.begin();
    for (const PairKey& pair : finder.broadPhase.pairs()) {
        const double thrown = finder.moving.thrown(pair);
        if (!finder.broadPhase.boundsMeet(pair, thrown)) continue;
        if (std::binary_search(finder.jointed.begin(), finder.jointed.end(), pair)) continue;
        const std::size_t first = finder.contacts.size();
        addContacts(bodies, pair, margin, larger(margin, thrown), dt, finder);
        if (finder.contacts.size() == first) continue;
        while (old != finder.previous.end() && PairKey{old->a, old->b} < pair) ++old;
        if (old != finder.previous.end() && PairKey{old->a, old->b} == pair)
            carryImpulses(*old, finder.contacts[first]);
    }
}

}  // namespace engine
