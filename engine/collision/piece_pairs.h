/// Which pieces of two bodies may meet within a step.
#pragma once
#include "engine/collision/broad_phase.h"
#include "engine/collision/pieces.h"
#include "engine/collision/time_of_impact.h"

namespace engine {

/// How far a body's points get within dt (s), at most, m.
inline double wayOf(const Motion& motion, double dt) {
    return dt * (motion.velocity.norm() + motion.sweep);
}

inline bool areWhole(const Bodies& bodies, const PairKey& pair) {
    return isWhole(bodies.defs[pair.a].shape) && isWhole(bodies.defs[pair.b].shape);
}

/// Calls visit(pieceA, pieceB) for the pieces that come as near as `near` (m) at least, in the order of
/// their numbers. `motions`: by body.
template <class Visit>
void forPiecePairs(const Bodies& bodies, const std::vector<Motion>& motions,
                   const BroadPhase& broadPhase, const PairKey& pair, double near, double dt,
                   Visit visit) {
    const Shape &shapeA = bodies.defs[pair.a].shape, &shapeB = bodies.defs[pair.b].shape;
    const double wayA = wayOf(motions[pair.a], dt), wayB = wayOf(motions[pair.b], dt);
    const Bounds everywhere{Vec3::Constant(-1e9), Vec3::Constant(1e9)};
    const bool plane = shapeA.type == ShapeType::plane || shapeB.type == ShapeType::plane;
    const Bounds aroundB =
        plane ? everywhere : broadPhase.bounds(pair.b).grownBy(wayA + near);
    forPieces(shapeA, bodies.poses[pair.a], aroundB, [&](const Piece& a) {
        const Bounds aroundA =
            plane ? everywhere
                  : boundsOf(a, bodies.poses[pair.a]).grownBy(wayA + wayB + near);
        forPieces(shapeB, bodies.poses[pair.b], aroundA,
                  [&](const Piece& b) { visit(a, b); });
    });
}

}  // namespace engine
