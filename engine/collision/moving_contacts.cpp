#include "engine/collision/moving_contacts.h"

#include <algorithm>

#include "engine/collision/collide.h"
#include "engine/collision/contact_making.h"
#include "engine/collision/sensors.h"
#include "engine/collision/surfaces.h"

namespace engine {
namespace {

constexpr int kMostLooks = 16;
constexpr double kFarToTurn = 0.4, kLittleToTurn = 1e-3;  // rad
constexpr int kMovingPairsAThread = 64;   // at least
constexpr double kSameDirection = 0.999;  // within 2.6 degrees
constexpr double kPasses = 1e-3;          // m in a step, by velocity alone: what rests has less
constexpr int kHops = 16;         // bodies that a hit passes through in a step
constexpr double kMostThrow = 2.0; // times the farthest throw of a hit

/// A pair in motion.
struct Pair {
    const Piece &pieceA, &pieceB;
    const Motion &a, &b;
    double shareOfA;  // 1 if only b can rotate, 0 if only a

    Pair(const Bodies& bodies, const PiecePair& pair, const MovingPairs& moving)
        : pieceA(pair.a), pieceB(pair.b), a(moving.motions[pair.bodies.a]),
          b(moving.motions[pair.bodies.b]) {
        const double easeA = bodies.inverseMasses[pair.bodies.a].angular.trace();
        const double easeB = bodies.inverseMasses[pair.bodies.b].angular.trace();
        shareOfA = easeA + easeB > 0.0 ? easeB / (easeA + easeB) : 0.5;
    }
    /// How fast the bodies approach at a present point, with its arms at the impact, m/s: -J v.
    double closingAt(const Vec3& p, const Manifold& m) const {
        const Vec3 ofA = a.velocity + a.spin.cross(p + m.slideA - a.start.position);
        const Vec3 ofB = b.velocity + b.spin.cross(p + m.slideB - b.start.position);
        return m.normal.dot(ofA - ofB);
    }
};

/// Moves the manifold of the poses at `time` back to the present; C is at least what is closed within `free`
/// (s). Motion across the normal until then would take the two points off the normal: a common point is taken,
/// nearer to that of the body that is easier to rotate, and what its arms lack until the impact is noted.
void seeFromNow(Manifold& m, const Pair& pair, double time, double free) {
    const Vec3 way = time * (pair.a.velocity - pair.b.velocity);
    const Vec3 slide = way - m.normal.dot(way) * m.normal;
    if (pair.shareOfA < 1.0 || pair.a.spin != Vec3::Zero()) m.slideA = -pair.shareOfA * slide;
    if (pair.shareOfA > 0.0 || pair.b.spin != Vec3::Zero()) m.slideB = (1.0 - pair.shareOfA) * slide;
    for (int i = 0; i < m.count; ++i) {
        const double then = m.separation(i);
        const Vec3 onA = m.points[i].onA - time * pair.a.velocity;
        const Vec3 onB = m.points[i].onB - time * pair.b.velocity;
        const Vec3 between = onB - onA;
        const Vec3 across = between - m.normal.dot(between) * m.normal;
        const Vec3 p = onA + pair.shareOfA * across;
        const double c = pair.closingAt(p, m);
        const double least = larger(smaller(then, 0.0), free * c);  // no push where none is needed
        const double now = larger(then + time * c, least);
        m.points[i].onA = p;
        m.points[i].onB = p + now * m.normal;
    }
}

/// The approach speed at the point that touches first, m/s.
double approachOf(const Manifold& m, const Pair& pair, double time) {
    int first = 0;
    for (int i = 1; i < m.count; ++i)
        if (m.separation(i) < m.separation(first)) first = i;
    const Vec3 armA = m.points[first].onA - pair.a.start.position - time * pair.a.velocity;
    const Vec3 armB = m.points[first].onB - pair.b.start.position - time * pair.b.velocity;
    const Vec3 leaving = (pair.b.velocity + pair.b.spin.cross(armB)) -
                         (pair.a.velocity + pair.a.spin.cross(armA));
    return larger(-m.normal.dot(leaving), 0.0);
}

/// True when `m` has a point or a normal that `other` lacks.
bool holdsMore(const Manifold& m, const Manifold& other) {
    if (m.count > 0 && m.normal.dot(other.normal) < kSameDirection) return true;
    for (int i = 0; i < m.count; ++i) {
        bool known = false;
        for (int j = 0; j < other.count; ++j)
            known = known || m.points[i].feature == other.points[j].feature;
        if (!known) return true;
    }
    return false;
}

bool areBoxes(const Pair& pair) {
    return pair.pieceA.isBox() && pair.pieceB.isBox();
}

/// The contact that forms when the pair stops approaching at `time` but continues to turn and slide: at the
/// end of the step, or, if that is nothing new, the faces next to two edges that hit each other.
Manifold afterImpact(const Pair& pair, const Manifold& first, double time, double margin,
                     double dt) {
    const double left = dt - time;
    Manifold m;
    if (left * (pair.a.sweep + pair.b.sweep) > margin) {
        const Vec3 stopped = left * approachOf(first, pair, time) * first.normal;
        Pose endB = pair.b.at(dt);
        endB.position += stopped;
        m = collide(pair.pieceA, pair.a.at(dt), pair.pieceB, endB, margin);
        for (int i = 0; i < m.count; ++i) m.points[i].onB -= stopped;
        if (holdsMore(m, first)) {
            seeFromNow(m, pair, dt, 0.0);
            return m;
        }
        m.count = 0;
    }
    if (first.count > 1 || !areBoxes(pair)) return m;
    m = collideBoxFaces(*pair.pieceA.shape, pair.pieceA.at(pair.a.at(time)), *pair.pieceB.shape,
                        pair.pieceB.at(pair.b.at(time)),
                        larger(margin, wayOf(pair.a, pair.b, left)));
    if (!holdsMore(m, first)) m.count = 0;
    seeFromNow(m, pair, time, 0.0);
    return m;
}

/// At least wayOf() squared, without a root: (x + y + z)^2 <= 3 (x^2 + y^2 + z^2).
double mostWaySquared(const Motion& a, const Motion& b, double dt) {
    return 3.0 * dt * dt * ((b.velocity - a.velocity).squaredNorm() + a.sweep * a.sweep + b.sweep * b.sweep);
}

/// True if no point of one moves past the other by kPasses; a bound as above.
bool hardlyMove(const Motion& a, const Motion& b, const Vec3& between, double dt) {
    const double most = between.squaredNorm() + a.spin.squaredNorm() * a.size * a.size +
                        b.spin.squaredNorm() * b.size * b.size;
    return 3.0 * dt * dt * most < kPasses * kPasses;
}

void sortUnique(std::vector<int>& list) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

bool bounces(const Bodies& bodies, const PairKey& pair) {
    return larger(bodies.defs[pair.a].material.restitution, bodies.defs[pair.b].material.restitution) > 0.0;
}

/// Throws a body that meets another one and would go on by `way` (m), by its share by inverse masses; one that moves
/// by itself, by as much as that, as the other may be held. `most`: of the throw, m.
void throwBody(const Bodies& bodies, int body, int other, double way, double most, double dt, MovingPairs& moving) {
    const double own = bodies.inverseMasses[body].linear, all = own + bodies.inverseMasses[other].linear;
    if (own <= 0.0 || way <= 0.0) return;
    const double stopped = smaller(way, dt * moving.motions[body].velocity.norm());
    const double e = together(bodies.defs[body].material, bodies.defs[other].material).restitution;
    moving.reach(body, smaller((1.0 + e) * larger(own / all * way, stopped), most));
}

/// By how much two bodies approach in the step, at most, less what they are apart, at least, m.
double wayInto(const MovingPairs& moving, const PairKey& pair, double dt) {
    const Motion &a = moving.motions[pair.a], &b = moving.motions[pair.b];
    const double apart = (b.start.position - a.start.position).norm() - a.size - b.size;
    return dt * (b.velocity - a.velocity).norm() - larger(apart, 0.0);
}

/// Finds the throws of the hits. What is left of a throw when the body comes to another one throws that one too, on
/// top of their own approach.
void findThrows(const Bodies& bodies, std::span<const PairKey> pairs, double margin, double dt,
                MovingPairs& moving) {
    for (const int i : moving.thrown) moving.throws[i] = 0.0;
    moving.thrown.clear();
    moving.throws.resize(bodies.count(), 0.0);
    const auto throwBoth = [&](const PairKey& pair, double ofA, double ofB, double most) {
        throwBody(bodies, pair.a, pair.b, ofA, most, dt, moving);
        throwBody(bodies, pair.b, pair.a, ofB, most, dt, moving);
    };
    for (const MovingPairs::Entry& entry : moving.entries) {
        const double way = dt * entry.impact.closing;
        if (entry.impact.meets) throwBoth(entry.pair, way, way, kFar);
    }
    double farthest = 0.0;
    for (const int i : moving.thrown) farthest = larger(farthest, moving.throws[i]);
    for (int hop = 0; hop < kHops && farthest > margin; ++hop) {
        moving.throwsBefore = moving.throws;  // so that the order of pairs does not matter
        const std::vector<double>& before = moving.throwsBefore;
        for (const PairKey& pair : pairs) {
            if (before[pair.a] <= margin && before[pair.b] <= margin) continue;
            const double into = wayInto(moving, pair, dt);
            throwBoth(pair, before[pair.b] + into, before[pair.a] + into, kMostThrow * farthest);
        }
        if (moving.throws == before) return;
    }
}

/// The first impact over all pieces; pairs of pieces that meet or pass closely are kept in `close`.
Impact firstImpact(const Bodies& bodies, const BroadPhase& broadPhase, const PairKey& pair,
                   double margin, const std::vector<Motion>& motions, double dt,
                   Looked& looked, std::vector<MovingPairs::Close>& close) {
    const Motion &a = motions[pair.a], &b = motions[pair.b];
    if (areWhole(bodies, pair))
        return timeOfImpact(bodies.defs[pair.a].shape, a, bodies.defs[pair.b].shape, b, dt, margin);
    Impact first{false, 0.0, 1e9, 0.0};
    forPiecePairs(bodies, motions, broadPhase, pair, margin, dt, looked,
                  [&](const Piece& pieceA, const Piece& pieceB) {
                      const Impact impact = timeOfImpact(pieceA, a, pieceB, b, dt, margin);
                      const bool sooner = first.meets ? impact.meets && impact.time < first.time
                                                      : impact.meets ||
                                                            impact.distance < first.distance;
                      if (sooner) first = impact;
                      if (impact.meets || impact.distance <= margin)
                          close.push_back({pieceA, pieceB, impact});
                  });
    return first;
}

/// How far a body has turned since its contacts were found, rad; 0 if that brings no other corner down.
double turnSince(const Bodies& bodies, int i, double time) {
    const Vec3& spin = bodies.velocities[i].angular;
    const ShapeType type = bodies.defs[i].shape.type;
    if (!bodies.isGoing(i) || !bodies.isDynamic(i) || type == ShapeType::sphere) return 0.0;
    if (spin.squaredNorm() * time * time < kLittleToTurn * kLittleToTurn) return 0.0;
    if (type != ShapeType::cylinder && type != ShapeType::capsule && type != ShapeType::cone)
        return spin.norm() * time;
    const Vec3 axis = bodies.poses[i].rotation * Vec3::UnitY();  // rotation about it changes nothing
    return axis.cross(spin).norm() * time;
}

}  // namespace

bool findImpacts(const Bodies& bodies, BroadPhase& broadPhase,
                 const JointedPairs& jointed, double margin, double dt,
                 Workers* workers, MovingPairs& moving) {
    moving.motions.resize(bodies.count());
    for (const int i : bodies.active) moving.motions[i] = motionOf(bodies, i, dt);
    moving.entries.clear();
    const double little = smaller(margin, dt * moving.bounceSpeed);
    for (const PairKey& key : broadPhase.awakePairs(bodies)) {
        if (bodies.isAsleep(key.a) && bodies.isAsleep(key.b)) continue;
        if (bodies.waits(key.a, key.b)) continue;
        const Motion &a = moving.motions[key.a], &b = moving.motions[key.b];
        if (mostWaySquared(a, b, dt) <= little * little) continue;
        const double least = bounces(bodies, key) ? smaller(margin, dt * moving.bounceSpeed) : margin;
        if (wayOf(a, b, dt) <= least || !broadPhase.boundsMeet(key)) continue;
        if (jointed.contains(key, bodies)) continue;
        if (isSensed(bodies, key)) continue;
        moving.entries.push_back({key, {}});
    }
    moving.close.resize(workers ? workers->count() : 1);
    for (std::vector<MovingPairs::Close>& close : moving.close) close.clear();
    moving.looked.assign(moving.close.size(), {});
    const auto look = [&](int first, int end, int part) {
        std::vector<MovingPairs::Close>& close = moving.close[part];
        for (int i = first; i < end; ++i) {
            MovingPairs::Entry& entry = moving.entries[i];
            entry.part = part, entry.first = static_cast<int>(close.size());
            entry.impact =
                firstImpact(bodies, broadPhase, entry.pair, margin, moving.motions, dt,
                            moving.looked[part], close);
            entry.count = static_cast<int>(close.size()) - entry.first;
        }
    };
    const int count = static_cast<int>(moving.entries.size());
    workers ? workers->share(count, kMovingPairsAThread, look) : look(0, count, 0);
    findThrows(bodies, broadPhase.awakePairs(bodies), margin, dt, moving);
    broadPhase.lookFarther(bodies, moving.thrown, moving.throws, margin);
    return !isTooMuch(moving.looked);
}

int looksNeeded(const MovingPairs& moving, const Bodies& bodies, double dt, std::vector<int>& fast) {
    double most = 1.0;
    for (const MovingPairs::Entry& entry : moving.entries) {
        if (!entry.impact.meets) continue;
        const Shape *shapes[2] = {&bodies.defs[entry.pair.a].shape, &bodies.defs[entry.pair.b].shape};
        const bool rough = shapes[0]->type == ShapeType::mesh || shapes[1]->type == ShapeType::mesh;
        double size = 1e9;  // m; a ball may turn freely, except that it may glance off one triangle onto
        for (const int k : {0, 1})  // the next, or bounce off one body onto another
            if (bodies.isDynamic(k == 0 ? entry.pair.a : entry.pair.b) &&
                (rough || bounces(bodies, entry.pair) || shapes[k]->type != ShapeType::sphere))
                size = smaller(size, 2.0 * reachOf(*shapes[k]));
        const Motion &a = moving.motions[entry.pair.a], &b = moving.motions[entry.pair.b];
        const double ways = wayOf(a, b, dt) / size;
        if (ways > 1.0) fast.push_back(entry.pair.a), fast.push_back(entry.pair.b);
        most = larger(most, ways);
    }
    sortUnique(fast);
    int looks = 1;
    while (looks < most && looks < kMostLooks) looks *= 2;
    return looks;
}

void findWhoTurnsFar(std::span<const Contact> contacts, const Bodies& bodies, std::span<const int> lookedAt,
                     int substep, double h, std::vector<int>& turned) {
    if (contacts.empty()) return;
    const auto turnOf = [&](int i) { return turnSince(bodies, i, (substep + bodies.strides[i] - lookedAt[i]) * h); };
    const auto wayOf = [&](int i, double turn) { return turn > 0.0 ? turn * reachOf(bodies.defs[i].shape) : 0.0; };
    double most = 0.0, farthest = 0.0, thinnest = kFar;  // rad, m, m
    for (const int i : bodies.active) {
        if (!bodies.isDynamic(i)) continue;
        const double turn = turnOf(i);
        most = larger(most, turn), farthest = larger(farthest, wayOf(i, turn));
        thinnest = smaller(thinnest, bodies.thicknesses[i]);
    }
    if (most <= kFarToTurn && farthest <= thinnest) return;  // fewer bodies than contacts
    for (const Contact& c : contacts) {
        const double thickness = bodies.thinner(c.a, c.b);
        for (const int i : {c.a, c.b}) {
            const double turn = turnOf(i);
            if (turn > kFarToTurn || wayOf(i, turn) > thickness) turned.push_back(i);
        }
    }
    sortUnique(turned);
}

const MovingPairs::Entry* MovingEntries::of(const PairKey& pair) {
    while (!left_.empty() && left_.front().pair < pair) left_ = left_.subspan(1);
    return !left_.empty() && left_.front().pair == pair ? &left_.front() : nullptr;
}

std::optional<Impact> impactOf(const Bodies& bodies, const PairKey& key, const MovingPairs::Entry* known,
                               const MovingPairs& moving, double margin, double near, double dt) {
    // An impact does not depend on `near`.
    if (known && (known->impact.meets || near <= margin)) return known->impact;
    if (near <= margin) return std::nullopt;
    return timeOfImpact(bodies.defs[key.a].shape, moving.motions[key.a], bodies.defs[key.b].shape,
                        moving.motions[key.b], dt, near);
}

const Impact* knownImpact(const MovingPairs& moving, const MovingPairs::Entry& entry,
                          const Piece& a, const Piece& b) {
    const auto numbersOf = [](const MovingPairs::Close& c) { return std::pair(c.a.number, c.b.number); };
    const std::span all = std::span(moving.close[entry.part]).subspan(entry.first, entry.count);
    const std::pair wanted(a.number, b.number);
    const auto found = std::ranges::lower_bound(all, wanted, {}, numbersOf);
    if (found == all.end() || numbersOf(*found) != wanted || !found->impact.meets) return nullptr;
    return &found->impact;
}

bool mayPass(const Contact& contact, const Bodies& bodies, const MovingPairs& moving, double dt) {
    const Motion &a = moving.motions[contact.a], &b = moving.motions[contact.b];
    const Velocity &ofA = bodies.velocities[contact.a], &ofB = bodies.velocities[contact.b];
    if (hardlyMove(a, b, ofB.linear - ofA.linear, dt)) return false;
    const Pose &poseA = bodies.poses[contact.a], &poseB = bodies.poses[contact.b];
    bool acts = false, moves = false;
    for (int i = 0; i < contact.count; ++i) {
        const Vec3 armA = poseA.rotation * contact.points[i].anchorA;
        const Vec3 armB = poseB.rotation * contact.points[i].anchorB;
        const double gap = contact.normal.dot((poseB.position + armB) - (poseA.position + armA));
        if (gap <= 0.0) return false;
        const Vec3 turning = b.spin.cross(armB) - a.spin.cross(armA);
        acts = acts || gap + dt * contact.normal.dot(b.velocity - a.velocity + turning) < 0.0;
        moves = moves || dt * dt * (ofB.linear - ofA.linear + turning).squaredNorm() > kPasses * kPasses;
    }
    return acts && moves;
}

MovingManifolds collideMoving(const Bodies& bodies, const PiecePair& pieces,
                              const MovingPairs& moving, const Impact& impact, double margin,
                              double near, double dt) {
    MovingManifolds found;
    if (!impact.meets && impact.distance > near) return found;
    const Pair pair(bodies, pieces, moving);
    const double left = dt - impact.time;
    Manifold& first = found.manifolds[0];
    first = collide(pair.pieceA, pair.a.at(impact.time), pair.pieceB, pair.b.at(impact.time),
                    larger(impact.distance, 0.0) + larger(margin, wayOf(pair.a, pair.b, left)));
    if (first.count == 0) return found;
    found.count = 1;
    if (impact.meets) {
        found.manifolds[1] = afterImpact(pair, first, impact.time, larger(margin, near), dt);
        if (found.manifolds[1].count > 0) found.count = 2;
    }
    if (impact.time > 0.0 || !impact.meets)
        seeFromNow(first, pair, impact.time, impact.meets ? 0.0 : dt);
    return found;
}

}  // namespace engine
