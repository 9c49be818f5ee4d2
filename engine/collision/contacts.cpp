#include "engine/collision/contacts.h"

#include <algorithm>
#include <span>

#include "engine/collision/collide.h"

namespace engine {
namespace {

constexpr double kSamePlace = 0.02;  // m
constexpr int kPairsAThread = 256;   // at least: fewer are looked at before they are shared out

Pose seenFrom(const Pose& a, const Pose& b) {
    return {a.toLocal(b.position), a.rotation.conjugate() * b.rotation};
}

enum class Found { here, onTheWay };  // at the present poses, or where the two will meet

Contact contactOf(const Bodies& bodies, const PairKey& pair, const Manifold& manifold, Found where) {
    const Material &a = bodies.defs[pair.a].material, &b = bodies.defs[pair.b].material;
    Contact contact;
    contact.a = pair.a, contact.b = pair.b;
    contact.normal = manifold.normal;
    contact.normalA = bodies.poses[pair.a].rotation.conjugate() * manifold.normal;
    if (where == Found::here)
        contact.seenFromA = seenFrom(bodies.poses[pair.a], bodies.poses[pair.b]);
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

/// Whether the two bodies have hardly moved against each other since the contact was found: less than a
/// quarter of the margin, so that no point is missed that may touch in the next step.
bool stays(const Contact& contact, const Bodies& bodies) {
    const auto isFlat = [&](int body) {  // what rolls gets new points as it goes
        const ShapeType type = bodies.defs[body].shape.type;
        return type == ShapeType::box || type == ShapeType::plane;
    };
    if (!isFlat(contact.a) || !isFlat(contact.b)) return false;
    constexpr double kWay = 5e-3, kTurn = 5e-3;  // m; sine of half the angle
    const Pose now = seenFrom(bodies.poses[contact.a], bodies.poses[contact.b]);
    const Quat turn = contact.seenFromA.rotation.conjugate() * now.rotation;
    return (now.position - contact.seenFromA.position).squaredNorm() < kWay * kWay &&
           turn.vec().squaredNorm() < kTurn * kTurn;
}

/// Kept as it is but for its normal, which turns with a: saves the search, and its points do not change
/// their names.
bool keepContact(const ContactFinder& finder, std::size_t old, const PairKey& pair,
                 const Bodies& bodies, std::vector<Contact>& found) {
    const std::vector<Contact>& previous = finder.previous;
    const auto isOfPair = [&](std::size_t i) {
        return i < previous.size() && pairOf(previous[i]) == pair;
    };
    if (!isOfPair(old) || isOfPair(old + 1) || !stays(previous[old], bodies)) return false;
    Contact& kept = found.emplace_back(previous[old]);
    kept.normal = bodies.poses[pair.a].rotation * kept.normalA;
    return true;
}

bool anyStirs(const Bodies& bodies) {
    for (int i = 0; i < bodies.count(); ++i)
        if (bodies.stirs(i)) return true;
    return false;
}

/// Neither stirs, and what contact they have is asleep. One that is about to be hit may be thrown
/// against another that it did not touch.
bool rests(const Bodies& bodies, std::span<const Contact> asleep, const PairKey& pair,
           double thrown) {
    if (!bodies.isAsleep(pair.a) && !bodies.isAsleep(pair.b)) return false;
    if (bodies.stirs(pair.a) || bodies.stirs(pair.b)) return false;
    return thrown == 0.0 || std::ranges::binary_search(asleep, pair, {}, pairOf);
}

/// Near: within the margin, or as far as this step's hits may throw the two. Up to two contacts. `old`:
/// the first of the previous contacts that is not of an earlier pair.
void addContacts(const Bodies& bodies, const PairKey& pair, double margin, double near, double dt,
                 std::size_t old, const ContactFinder& finder, std::vector<Contact>& found) {
    if (const std::optional<Impact> impact =
            impactOf(bodies, pair, finder.moving, near > margin, dt)) {
        const MovingManifolds met =
            collideMoving(bodies, pair, finder.moving, *impact, margin, near, dt);
        for (int i = 0; i < met.count; ++i)
            found.push_back(contactOf(bodies, pair, met.manifolds[i], Found::onTheWay));
        return;
    }
    if (keepContact(finder, old, pair, bodies, found)) return;
    const Manifold manifold =
        collide(bodies.defs[pair.a].shape, bodies.poses[pair.a], bodies.defs[pair.b].shape,
                bodies.poses[pair.b], margin);
    if (manifold.count > 0) found.push_back(contactOf(bodies, pair, manifold, Found::here));
}

/// Of some of the pairs, in their order.
void findOfPairs(const Bodies& bodies, std::span<const PairKey> pairs, double margin, double dt,
                 const ContactFinder& finder, std::vector<Contact>& found) {
    const std::vector<Contact>& previous = finder.previous;
    const auto isBefore = [](const Contact& c, const PairKey& pair) { return pairOf(c) < pair; };
    std::size_t old = 0;
    if (!pairs.empty())
        old = std::lower_bound(previous.begin(), previous.end(), pairs.front(), isBefore) -
              previous.begin();
    for (const PairKey& pair : pairs) {
        const double thrown = finder.moving.thrown(pair);
        if (rests(bodies, finder.asleep, pair, thrown)) continue;
        if (!finder.broadPhase.boundsMeet(pair, thrown)) continue;
        if (std::binary_search(finder.jointed.begin(), finder.jointed.end(), pair)) continue;
        if (isSensed(bodies, pair)) continue;
        while (old < previous.size() && isBefore(previous[old], pair)) ++old;
        const std::size_t first = found.size();
        addContacts(bodies, pair, margin, larger(margin, thrown), dt, old, finder, found);
        if (found.size() > first && old < previous.size() && pairOf(previous[old]) == pair)
            carryImpulses(previous[old], found[first]);
    }
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
    finder.contacts.swap(finder.previous);
    finder.contacts.clear();
    if (!anyStirs(bodies)) return;
    finder.broadPhase.update(bodies, margin, dt, finder.workers);
    if (bodies.hasSensors) findSensed(bodies, finder.broadPhase, finder.sensed);
    const int threads = finder.workers ? finder.workers->count() : 1;
    findImpacts(bodies, finder.broadPhase, finder.jointed, margin, dt, finder.workers,
                finder.moving);
    const std::vector<PairKey>& pairs = finder.broadPhase.pairs();
    finder.found.resize(threads);
    for (std::vector<Contact>& found : finder.found) found.clear();
    const auto look = [&](int first, int end, int part) {
        findOfPairs(bodies, std::span(pairs).subspan(first, end - first), margin, dt, finder,
                    finder.found[part]);
    };
    const int count = static_cast<int>(pairs.size());
    finder.workers ? finder.workers->share(count, kPairsAThread, look) : look(0, count, 0);
    finder.contacts.swap(finder.found[0]);
    for (int i = 1; i < threads; ++i)
        finder.contacts.insert(finder.contacts.end(), finder.found[i].begin(), finder.found[i].end());
}

}  // namespace engine
