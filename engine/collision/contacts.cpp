#include "engine/collision/contacts.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "engine/collision/collide.h"
#include "engine/collision/piece_contacts.h"

namespace engine {
namespace {

constexpr double kSamePlace = 0.02;  // m
constexpr double kSameWay = 0.95;    // cosine, between normals
constexpr int kPairsAThread = 256;   // at least

/// Keeps the previous contact with its impulses; only its normal turns with a. This saves the search, and the points
/// keep their features.
bool keepContact(const ContactFinder& finder, std::size_t old, const PairKey& pair,
                 const Bodies& bodies, double dt, std::vector<Contact>& found) {
    const std::vector<Contact>& previous = finder.previous;
    const auto isOfPair = [&](std::size_t i) {
        return i < previous.size() && pairOf(previous[i]) == pair;
    };
    if (!isOfPair(old) || isOfPair(old + 1) || !stays(previous[old], bodies)) return false;
    found.push_back(previous[old]);
    follow(found.back(), bodies);
    if (!mayPass(found.back(), bodies, finder.moving, dt)) return true;
    found.pop_back();
    return false;
}

bool anyStirs(const Bodies& bodies) {
    for (const int i : bodies.active)
        if (bodies.stirs(i)) return true;
    return false;
}

/// Neither stirs, and their contact, if any, is asleep. A body about to be hit may be thrown against another
/// that it did not touch.
bool rests(const Bodies& bodies, std::span<const Contact> asleep, const PairKey& pair,
           double thrown) {
    if (!bodies.isAsleep(pair.a) && !bodies.isAsleep(pair.b)) return false;
    if (bodies.stirs(pair.a) || bodies.stirs(pair.b)) return false;
    return thrown == 0.0 || std::ranges::binary_search(asleep, pair, {}, pairOf);
}

/// Adds up to two contacts. `near` (m): the margin, or as far as the hits of this step may throw the two.
/// `old`: the first previous contact that does not belong to an earlier pair. Returns true if it was kept.
bool addContacts(const Bodies& bodies, const PairKey& pair, const MovingPairs::Entry* known, double margin,
                 double near, double dt, std::size_t old, const ContactFinder& finder,
                 std::vector<Contact>& found) {
    const PiecePair whole{pair, wholeOf(bodies.defs[pair.a].shape),
                          wholeOf(bodies.defs[pair.b].shape)};
    const auto meet = [&](const Impact& impact) {
        const MovingManifolds met = collideMoving(bodies, whole, finder.moving, impact, margin, near, dt);
        for (int i = 0; i < met.count; ++i)
            found.push_back(contactOf(bodies, pair, met.manifolds[i], Found::onTheWay));
        return false;
    };
    if (const auto impact = impactOf(bodies, pair, known, finder.moving, margin, near, dt)) return meet(*impact);
    if (keepContact(finder, old, pair, bodies, dt, found)) return true;
    const Shape &a = bodies.defs[pair.a].shape, &b = bodies.defs[pair.b].shape;
    const Manifold manifold = collide(a, bodies.poses[pair.a], b, bodies.poses[pair.b], margin);
    if (manifold.count == 0) return false;
    const Contact contact = contactOf(bodies, pair, manifold, Found::here);
    if (!mayPass(contact, bodies, finder.moving, dt)) return found.push_back(contact), false;
    return meet(timeOfImpact(a, finder.moving.motions[pair.a], b, finder.moving.motions[pair.b], dt, near));
}

/// The contact of the pair in the last step with nearly the same normal, from `old` on. For pairs of whole
/// shapes only the first contact counts, whatever its normal. Null: there is none.
const Contact* sameAs(const Contact& contact, const std::vector<Contact>& previous,
                      std::size_t old, bool isFirst, bool areWhole) {
    const Contact* same = nullptr;
    double most = kSameWay;
    for (; old < previous.size() && pairOf(previous[old]) == pairOf(contact); ++old) {
        if (areWhole) return isFirst ? &previous[old] : nullptr;
        const double along = previous[old].normalA.dot(contact.normalA);
        if (along > most) most = along, same = &previous[old];
    }
    return same;
}

/// Finds the contacts of some of the pairs, in their order.
void findOfPairs(const Bodies& bodies, std::span<const PairKey> pairs, double margin, double dt,
                 const ContactFinder& finder, Looked& looked, std::vector<Contact>& found) {
    const std::vector<Contact>& previous = finder.previous;
    const auto isBefore = [](const Contact& c, const PairKey& pair) { return pairOf(c) < pair; };
    if (pairs.empty()) return;
    std::size_t old =
        std::lower_bound(previous.begin(), previous.end(), pairs.front(), isBefore) - previous.begin();
    MovingEntries entries(finder.moving, pairs.front());
    for (const PairKey& pair : pairs) {
        if (found.size() > kMostContacts || isTooMuch({&looked, 1})) return;
        const double thrown = finder.moving.throwOf(pair);
        if (bodies.waits(pair.a, pair.b) || rests(bodies, finder.asleep, pair, thrown)) continue;
        if (!finder.broadPhase.boundsMeet(pair, thrown)) continue;
        if (finder.jointed.contains(pair, bodies)) continue;
        if (isSensed(bodies, pair)) continue;
        while (old < previous.size() && isBefore(previous[old], pair)) ++old;
        const std::size_t first = found.size();
        const double near = larger(margin, thrown);
        const bool whole = areWhole(bodies, pair);
        const MovingPairs::Entry* known = entries.of(pair);
        const bool kept = whole ? addContacts(bodies, pair, known, margin, near, dt, old, finder, found)
                                : addContactsOfPieces(bodies, pair, finder.broadPhase, finder.moving, known,
                                                      margin, near, dt, previous, old, looked, found);
        for (std::size_t i = first; !kept && i < found.size(); ++i)
            if (const Contact* from = sameAs(found[i], previous, old, i == first, whole))
                carryImpulses(*from, found[i]);
    }
}

/// Adds the previous contacts of bodies that wait; the contacts stay sorted.
void keepWaiting(const Bodies& bodies, const std::vector<Contact>& previous,
                 std::vector<Contact>& contacts) {
    const auto found = static_cast<std::ptrdiff_t>(contacts.size());
    std::ranges::copy_if(previous, std::back_inserter(contacts),
                         [&](const Contact& c) { return bodies.waits(c.a, c.b); });
    std::inplace_merge(contacts.begin(), contacts.begin() + found, contacts.end(),
                       [](const Contact& l, const Contact& r) { return pairOf(l) < pairOf(r); });
}

}  // namespace

void carryImpulses(const Contact& from, Contact& to) {
    to.depth = from.depth;
    to.rollingMoment = from.rollingMoment;
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
    // Points with another feature in the same place (for example after the reference face has changed).
    for (int i = 0; i < to.count; ++i)
        for (int j = 0; j < from.count && !found[i]; ++j)
            if (!taken[j] && (to.points[i].anchorA - from.points[j].anchorA).squaredNorm() <
                                 kSamePlace * kSamePlace)
                carry(i, j);
}

void findContacts(const Bodies& bodies, ContactFinder& finder, double margin, double dt) {
    finder.contacts.swap(finder.previous);
    finder.contacts.clear();
    finder.tooMany = false;
    if (!anyStirs(bodies)) return;
    finder.broadPhase.update(bodies, margin, dt, finder.workers);
    finder.tooMany = finder.broadPhase.isCrowded();
    if (finder.tooMany) return;
    finder.tooMany = bodies.hasSensors && !findSensed(bodies, finder.broadPhase, finder.sensed);
    if (finder.tooMany) return;
    const int threads = finder.workers ? finder.workers->count() : 1;
    const bool fits = findImpacts(bodies, finder.broadPhase, finder.jointed, margin, dt,
                                  finder.workers, finder.moving);
    finder.tooMany = !fits || finder.broadPhase.isCrowded();
    if (finder.tooMany) return;
    // A body that sleeps may be thrown against others.
    const std::vector<PairKey>& pairs = finder.moving.thrown.empty()
                                            ? finder.broadPhase.awakePairs(bodies)
                                            : finder.broadPhase.pairs();
    finder.found.resize(threads);
    finder.found[0].swap(finder.contacts);  // its memory: a contact takes half a kilobyte
    for (std::vector<Contact>& found : finder.found) found.clear();
    finder.looked.assign(threads, {});
    const auto look = [&](int first, int end, int part) {
        findOfPairs(bodies, std::span(pairs).subspan(first, end - first), margin, dt, finder,
                    finder.looked[part], finder.found[part]);
    };
    const int count = static_cast<int>(pairs.size());
    finder.workers ? finder.workers->share(count, kPairsAThread, look) : look(0, count, 0);
    std::size_t all = 0;
    for (const std::vector<Contact>& found : finder.found) all += found.size();
    finder.tooMany = all > kMostContacts || isTooMuch(finder.looked);
    if (finder.tooMany) return;
    finder.contacts.swap(finder.found[0]);
    for (int i = 1; i < threads; ++i)
        finder.contacts.insert(finder.contacts.end(), finder.found[i].begin(), finder.found[i].end());
    finder.seams.leaveOut(bodies, dt, finder.contacts);
    keepWaiting(bodies, finder.previous, finder.contacts);
}

}  // namespace engine
