#include "engine/collision/piece_contacts.h"

#include <utility>

#include "engine/collision/clip.h"
#include "engine/collision/collide.h"

namespace engine {
namespace {

constexpr double kSameNormal = 0.9995;      // within 1.8 degrees
constexpr double kSamePlane = 1.0 - 1e-12;  // except for rounding

/// A feature that is unique over the pairs of pieces.
int featureOf(int feature, const Piece& a, const Piece& b) {
    const unsigned mixed =
        (static_cast<unsigned>(feature) * 31u + static_cast<unsigned>(a.number)) * 10007u +
        static_cast<unsigned>(b.number);
    return static_cast<int>(mixed & 0x7fffffffu);
}

/// Whether it was made on the way, from poses to come.
bool isAhead(const Contact& contact) { return contact.seenFromA.position == Contact{}.seenFromA.position; }

/// Keeps the four best points of both contacts, along the normal of the one that touches first; the other's
/// normal may be that of an edge hidden by the next piece.
void merge(const Bodies& bodies, Contact more, Contact& into) {
    const bool askew = into.normal.dot(more.normal) < kSamePlane;
    if (askew && deepestOf(more, bodies) < deepestOf(into, bodies)) std::swap(more, into);
    if (isAhead(more) != isAhead(into)) {  // for this step only
        into.slideA.setZero(), into.slideB.setZero();
        into.seenFromA = Contact{}.seenFromA;
    }
    std::array<ContactPoint, 8> all;
    ClippedPoints<8> points;
    const Pose &a = bodies.poses[into.a], &b = bodies.poses[into.b];
    const Contact* const both[] = {&into, &more};
    for (const Contact* from : both)
        for (int i = 0; i < from->count; ++i) {
            const Vec3 onA = a.toWorld(from->points[i].anchorA);
            const double separation =
                into.normal.dot(b.toWorld(from->points[i].anchorB) - onA);
            ContactPoint& point = all[points.count];
            point = from->points[i];
            point.anchorB = b.toLocal(onA + separation * into.normal);
            points.position[points.count] = onA;
            points.separation[points.count] = separation;
            points.label[points.count] = points.count;
            ++points.count;
        }
    points.keepFour(into.normal);
    into.count = points.count;
    for (int i = 0; i < points.count; ++i) into.points[i] = all[points.label[i]];
}

void add(const Bodies& bodies, const Contact& contact, std::size_t first,
         std::vector<Contact>& found) {
    for (std::size_t i = first; i < found.size(); ++i)
        if (found[i].normal.dot(contact.normal) > kSameNormal)
            return merge(bodies, contact, found[i]);
    found.push_back(contact);
}

bool keepAll(const std::vector<Contact>& previous, std::size_t old, const PairKey& pair,
             const Bodies& bodies, const MovingPairs& moving, double dt, std::vector<Contact>& found) {
    std::size_t end = old;
    const auto isOfPair = [&](const Contact& c) { return c.a == pair.a && c.b == pair.b; };
    for (; end < previous.size() && isOfPair(previous[end]); ++end)
        if (!stays(previous[end], bodies)) return false;
    const std::size_t first = found.size();
    for (std::size_t i = old; i < end; ++i) {
        found.push_back(previous[i]);
        follow(found.back(), bodies);
        if (!mayPass(found.back(), bodies, moving, dt)) continue;
        found.resize(first);
        return false;
    }
    return end > old;
}

}  // namespace

bool addContactsOfPieces(const Bodies& bodies, const PairKey& pair, const BroadPhase& broadPhase,
                         const MovingPairs& moving, const MovingPairs::Entry* known, double margin,
                         double near, double dt,
                         const std::vector<Contact>& previous, std::size_t old, Looked& looked,
                         std::vector<Contact>& found) {
    const bool thrown = near > margin;
    if (!known && !thrown && keepAll(previous, old, pair, bodies, moving, dt, found)) return true;
    const std::size_t first = found.size();
    const auto take = [&](Manifold& m, const PiecePair& pieces, Found where) {
        for (int i = 0; i < m.count; ++i)
            m.points[i].feature = featureOf(m.points[i].feature, pieces.a, pieces.b);
        if (m.count > 0) add(bodies, contactOf(bodies, pair, m, where), first, found);
        const bool tooMany = where == Found::here && found.size() - first > kMostContactsOfPair;
        looked.crowded = looked.crowded || tooMany;
    };
    const auto meet = [&](const Piece& a, const Piece& b, const Impact& impact) {
        const PiecePair pieces{pair, a, b};
        MovingManifolds met = collideMoving(bodies, pieces, moving, impact, margin, near, dt);
        for (int i = 0; i < met.count; ++i) take(met.manifolds[i], pieces, Found::onTheWay);
    };
    const auto impactOf = [&](const Piece& a, const Piece& b) {
        const Impact* impact = known ? knownImpact(moving, *known, a, b) : nullptr;
        if (impact) return *impact;
        return timeOfImpact(a, moving.motions[pair.a], b, moving.motions[pair.b], dt, near);
    };
    if (known && !thrown) {
        for (int i = known->first; i < known->first + known->count; ++i) {
            const MovingPairs::Close& close = moving.close[known->part][i];
            meet(close.a, close.b, close.impact);
        }
        return false;
    }
    forPiecePairs(bodies, moving.motions, broadPhase, pair, near, dt, looked,
                  [&](const Piece& a, const Piece& b) {
                      if (thrown) return meet(a, b, impactOf(a, b));
                      Manifold m =
                          collide(a, bodies.poses[pair.a], b, bodies.poses[pair.b], margin);
                      if (m.count == 0) return;
                      if (mayPass(contactOf(bodies, pair, m, Found::here), bodies, moving, dt))
                          return meet(a, b, impactOf(a, b));
                      take(m, {pair, a, b}, Found::here);
                  });
    return false;
}

}  // namespace engine
