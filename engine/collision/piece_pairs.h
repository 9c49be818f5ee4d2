/// Which pieces of two bodies may meet within a step.
#pragma once
#include <span>

#include "engine/collision/broad_phase.h"
#include "engine/collision/pieces.h"
#include "engine/collision/time_of_impact.h"
#include "engine/shapes/hull.h"

namespace engine {

/// With more pairs of pieces to look at in one step, or more contacts of two bodies where they are, no step is done:
/// these are bodies deep in fine meshes. A fast body may have more contacts ahead of it, on rough ground.
inline constexpr long kMostPiecePairs = 4'000'000;
inline constexpr std::size_t kMostContactsOfPair = 2000;

/// What one thread has looked at in a step.
struct Looked {
    long pieces = 0;       // pairs of them, those of large hulls several times
    bool crowded = false;  // two bodies had too many contacts
};

/// `looked`: by thread. The same whatever their number.
inline bool isTooMuch(std::span<const Looked> looked) {
    long pieces = 0;
    for (const Looked& own : looked) {
        if (own.crowded) return true;
        pieces += own.pieces;
    }
    return pieces > kMostPiecePairs;
}

/// The farthest that any point of a body moves within dt (s), m.
inline double wayOf(const Motion& motion, double dt) {
    return dt * (motion.velocity.norm() + motion.sweep);
}

/// How often a pair of pieces counts: a corner of a hull costs time.
inline long costOf(const Piece& a, const Piece& b) {
    const auto corners = [](const Piece& p) {
        return p.shape->type == ShapeType::hull ? static_cast<long>(p.shape->hull->corners.size()) : 0;
    };
    return 1 + (corners(a) + corners(b)) / 32;
}

inline bool areWhole(const Bodies& bodies, const PairKey& pair) {
    return isWhole(bodies.defs[pair.a].shape) && isWhole(bodies.defs[pair.b].shape);
}

/// Calls visit(pieceA, pieceB) for all pairs of pieces that may come within `near` (m), in the order of their
/// numbers. `motions`: by body. Adds their number to `looked`; beyond kMostPiecePairs they are only counted.
template <class Visit>
void forPiecePairs(const Bodies& bodies, const std::vector<Motion>& motions,
                   const BroadPhase& broadPhase, const PairKey& pair, double near, double dt,
                   Looked& looked, Visit visit) {
    const auto look = [&](const Piece& a, const Piece& b) {
        if (looked.pieces <= kMostPiecePairs && !looked.crowded) visit(a, b);
        looked.pieces += costOf(a, b);
    };
    const Shape &shapeA = bodies.defs[pair.a].shape, &shapeB = bodies.defs[pair.b].shape;
    const double wayA = wayOf(motions[pair.a], dt), wayB = wayOf(motions[pair.b], dt);
    if (shapeA.type == ShapeType::plane || shapeB.type == ShapeType::plane) {
        const Bounds everywhere{Vec3::Constant(-1e9), Vec3::Constant(1e9)};
        forPieces(shapeA, bodies.poses[pair.a], everywhere, [&](const Piece& a) {
            forPieces(shapeB, bodies.poses[pair.b], everywhere, [&](const Piece& b) { look(a, b); });
        });
        return;
    }
    // The broad phase's bounds include each body's motion within the step.
    const Bounds reachA = broadPhase.bounds(pair.a).grownBy(wayB + near);
    const Bounds reachB = broadPhase.bounds(pair.b).grownBy(wayA + near);
    const bool wholeA = isWhole(shapeA);
    forPieces(shapeA, bodies.poses[pair.a], reachB, [&](const Piece& a) {
        const Bounds now = wholeA ? reachA : boundsOf(a, bodies.poses[pair.a]);
        if (!now.overlaps(reachB)) return;
        const Bounds around = wholeA ? reachA : now.grownBy(wayA + wayB + near);
        forPieces(shapeB, bodies.poses[pair.b], around, [&](const Piece& b) { look(a, b); });
    });
}

}  // namespace engine
