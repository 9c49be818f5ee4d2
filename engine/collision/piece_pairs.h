/// Which pieces of two bodies may meet within a step.
#pragma once
#include "engine/collision/broad_phase.h"
#include "engine/collision/pieces.h"
#include "engine/collision/time_of_impact.h"

namespace engine {

/// The farthest that any point of a body moves within dt (s), m.
inline double wayOf(const Motion& motion, double dt) {
    return dt * (motion.velocity.norm() + motion.sweep);
}

inline bool areWhole(const Bodies& bodies, const PairKey& pair) {
    return isWhole(bodies.defs[pair.a].shape) && isWhole(bodies.defs[pair.b].shape);
}

/// Calls visit(pieceA, pieceB) for all pairs of pieces that may come within `near` (m), in the order of their
/// numbers. `motions`: by body.
template <class Visit>
void forPiecePairs(const Bodies& bodies, const std::vector<Motion>& motions,
                   const BroadPhase& broadPhase, const PairKey& pair, double near, double dt,
                   Visit visit) {
    const Shape &shapeA = bodies.defs[pair.a].shape, &shapeB = bodies.defs[pair.b].shape;
    const double wayA = wayOf(motions[pair.a], dt), wayB = wayOf(motions[pair.b], dt);
    if (shapeA.type == ShapeType::plane || shapeB.type == ShapeType::plane) {
        const Bounds everywhere{Vec3::Constant(-1e9), Vec3::Constant(1e9)};
        forPieces(shapeA, bodies.poses[pair.a], everywhere, [&](const Piece& a) {
            forPieces(shapeB, bodies.poses[pair.b], everywhere, [&](const Piece& b) { visit(a, b); });
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
        forPieces(shapeB, bodies.poses[pair.b], around, [&](const Piece& b) { visit(a, b); });
    });
}

}  // namespace engine
