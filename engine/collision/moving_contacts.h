/// The contacts of fast pairs: found at the poses where they will touch, and given to the solver as if at the
/// present poses. With the normal n and the points of the time t of impact, and with
///   C = C_then - t J v
/// the solver's linear model of the motion closes the gap at exactly that time. Motion across n would make one arm
/// wrong: the rows have the arms r of time t (Contact::slideA), which keep balls without friction from turning.
/// A body that only passes another is not stopped by the infinite plane of a contact far ahead: not one that moves
/// more than the margin, and not a slower or smaller one (mayPass).
///
/// Free motion ends with the first impact, so there are two further sources of contacts:
///   * a pair that touches continues to turn about its contact: a second manifold, at the poses of the
///     step's end without the approach, holds the features that come down then
///   * a body that hits something may be thrown against its neighbours in the same step, or is stopped while those
///     behind it are not, as what it hits may be held. It leaves its free motion by at most
///       throw_a = dt (1 + e) max(c m_b / (m_a + m_b), min(c, |v_a|))             (m)
///     c: how fast the two approach, m/s, to which dt c is added what throw_b exceeds their distance by; so throws
///     go from body to body. Bodies less than throw_a + throw_b apart get a contact, with a C so large that it
///     does not affect free motion.
#pragma once
#include <algorithm>
#include <optional>
#include <span>

#include "engine/base/workers.h"
#include "engine/collision/jointed_pairs.h"
#include "engine/collision/piece_pairs.h"
#include "engine/collision/manifold.h"
#include "engine/constraints/contact.h"

namespace engine {

/// The free motion of the coming step. Kept between steps only to reuse its memory.
struct MovingPairs {
    /// Two pieces that meet, or pass within the margin.
    struct Close {
        Piece a, b;
        Impact impact;
    };
    struct Entry {
        PairKey pair;
        Impact impact;
        int part = 0, first = 0, count = 0;  // of compounds and meshes: close[part][first], ...
    };
    double bounceSpeed = kFar;    // m/s: pairs that bounce and are faster need the normal at the impact
    std::vector<Motion> motions;  // by body
    std::vector<Entry> entries;   // the pairs that move more than the margin, or bounce; sorted
    std::vector<std::vector<Close>> close;  // a list for each thread
    std::vector<Looked> looked;   // by thread
    std::vector<double> throws;   // m, by body; all zero if nothing is hit
    std::vector<double> throwsBefore;
    std::vector<int> thrown;      // bodies whose throw is not zero

    /// The body is thrown by up to `way` (m).
    void reach(int body, double way) {
        double& farthest = throws[body];
        if (farthest == 0.0 && way > 0.0) thrown.push_back(body);
        farthest = larger(farthest, way);
    }
    /// How much closer the hits of this step may bring the two, m.
    double throwOf(const PairKey& pair) const { return throws[pair.a] + throws[pair.b]; }
};

/// Finds impacts and throws of all pairs that move more than `margin` (m) within dt (s), or bounce, and adds to the
/// broad phase the pairs of bodies that may be thrown beyond their bounds. The pairs `jointed` do
/// not collide. `workers`, if given, share the pairs. False if they have too many pieces (isTooMuch).
[[nodiscard]] bool findImpacts(const Bodies& bodies, BroadPhase& broadPhase,
                               const JointedPairs& jointed, double margin, double dt,
                               Workers* workers, MovingPairs& moving);

/// How often the coming step of dt (s) needs contact detection, at most sixteen times: once, unless a body
/// that hits something moves farther than its own size. A body hit at one corner turns, and may come down on
/// another before the step ends. A power of two, so that islands that need none still find their number of
/// sub-steps. Adds the bodies that need more than one to `fast`.
int looksNeeded(const MovingPairs& moving, const Bodies& bodies, double dt, std::vector<int>& fast);

/// Adds the bodies of contacts that do not wait and will have turned so far by their next sub-step that other
/// corners of them may come down: by 0.4 rad, or by a way longer than the thinner of the two is thick. `lookedAt`:
/// by body, the world's sub-step, of length h (s), in which its contacts were found.
void findWhoTurnsFar(std::span<const Contact> contacts, const Bodies& bodies, std::span<const int> lookedAt,
                     int substep, double h, std::vector<int>& turned);

/// Null if the margin is enough for the pair; `near` (m) above the margin: never, and only that is certain of
/// pairs that stay farther apart. `known`: the pair's entry, if any.
std::optional<Impact> impactOf(const Bodies& bodies, const PairKey& pair, const MovingPairs::Entry* known,
                               const MovingPairs& moving, double margin, double near, double dt);
/// The impact of two pieces, if the entry of their bodies has one.
const Impact* knownImpact(const MovingPairs& moving, const MovingPairs::Entry& entry,
                          const Piece& a, const Piece& b);
/// Finds the entries of pairs that are asked for in their order.
class MovingEntries {
public:
    MovingEntries(const MovingPairs& moving, const PairKey& first)
        : left_(std::ranges::lower_bound(moving.entries, first, {}, &MovingPairs::Entry::pair),
                moving.entries.end()) {}
    /// Null if the margin is enough for the pair.
    const MovingPairs::Entry* of(const PairKey& pair);

private:
    std::span<const MovingPairs::Entry> left_;
};

/// Whether a contact of the present poses would act although the bodies may pass each other: they are apart, they
/// move, and in free motion would cross its plane.
bool mayPass(const Contact& contact, const Bodies& bodies, const MovingPairs& moving, double dt);

/// A piece of each of two bodies; for most bodies, the whole shape.
struct PiecePair {
    PairKey bodies;
    Piece a, b;
};

struct MovingManifolds {
    int count = 0;
    std::array<Manifold, 2> manifolds;  // points at the present poses
};

/// `near` (m): a pair that passes within this distance gets a contact as well.
MovingManifolds collideMoving(const Bodies& bodies, const PiecePair& pair,
                              const MovingPairs& moving, const Impact& impact, double margin,
                              double near, double dt);

}  // namespace engine
