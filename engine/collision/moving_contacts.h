/// The contacts of pairs that move fast: those of the poses in which they will touch, told to the
/// solver as if seen from now. With the normal n and the points of the time t of the impact, and
/// with
///   C = C_then - t J v
/// the solver's linear picture of the motion closes the gap at that very time; a body that would
/// only pass another is not stopped by the endless plane of a contact far ahead.
///
/// Free motion ends with the first impact, so two further sources of contacts are looked after:
///   * a pair that touches turns on about its contact: a second manifold, of the poses at the
///     step's end with the approach taken out, holds the features that come down then
///   * a body that is hit may be thrown against its neighbours in the same step, by at most
///       throw_a = dt (1 + e) c m_b / (m_a + m_b)              (m)
///     which it passes on to whom it hits in its turn. Whoever stays apart by less than
///     throw_a + throw_b gets a contact, with so large a C that free motion alone is not touched by
///     it.
#pragma once
#include <optional>
#include <span>

#include "engine/base/workers.h"
#include "engine/collision/piece_pairs.h"
#include "engine/collision/manifold.h"
#include "engine/constraints/contact.h"

namespace engine {

/// What free motion would do in the coming step: kept from step to step for its memory only.
struct MovingPairs {
    /// Pieces that meet, or pass within the margin.
    struct Close {
        Piece a, b;
        Impact impact;
    };
    struct Entry {
        PairKey pair;
        Impact impact;
        int part = 0, first = 0, count = 0;  // of compounds and meshes: close[part][first], ...
    };
    std::vector<Motion> motions;  // by body
    std::vector<Entry> entries;   // of the pairs that move more than the margin; sorted
    std::vector<std::vector<Close>> close;  // a list for each thread
    std::vector<double> throws;   // m, by body: dt jolt; all zero while nothing is hit
    std::vector<double> throwsBefore;

    /// How far the hits of this step may bring the two together, m.
    double thrown(const PairKey& pair) const { return throws[pair.a] + throws[pair.b]; }
};

/// Impacts and throws of all pairs that move more than `margin` (m) within dt (s); the broad phase
/// gets the pairs of bodies that may be thrown farther than it sees. `jointed`, sorted, do not
/// collide. `workers` share the pairs, if there are any.
void findImpacts(const Bodies& bodies, BroadPhase& broadPhase,
                 const std::vector<PairKey>& jointed, double margin, double dt,
                 Workers* workers, MovingPairs& moving);

/// How often contacts have to be found in the coming step of dt (s), at most sixteen times: once, where
/// nothing meets that covers more than its own size in it. What is hit at a corner turns, and comes down
/// with another before the step is over.
int looksNeeded(const MovingPairs& moving, const Bodies& bodies, double dt);

/// Whether a body of a contact turns so far within `time` (s), since its contacts were found, that others
/// of its corners may come down.
bool anyTurnsFar(std::span<const Contact> contacts, const Bodies& bodies, double time);

/// Nothing for a pair that the margin is enough for; `always`: found now, for more than the margin.
std::optional<Impact> impactOf(const Bodies& bodies, const PairKey& pair,
                               const MovingPairs& moving, bool always, double dt);
/// Null: the margin is enough for the pair.
const MovingPairs::Entry* movingEntry(const MovingPairs& moving, const PairKey& pair);

/// Two bodies' pieces; of most bodies, the whole.
struct PiecePair {
    PairKey bodies;
    Piece a, b;
};

struct MovingManifolds {
    int count = 0;
    std::array<Manifold, 2> manifolds;  // points as of the present poses
};

/// `near` (m): a pair that passes this closely gets a contact as well.
MovingManifolds collideMoving(const Bodies& bodies, const PiecePair& pair,
                              const MovingPairs& moving, const Impact& impact, double margin,
                              double near, double dt);

}  // namespace engine
