/// When two bodies will first touch within the coming step: continuous collision detection.
///
/// Conservative advancement (Mirtich 1996; van den Bergen, GDC 2010; Catto, GDC 2013). Let the
/// shapes be `d` apart along the unit vector n, which points from a to b. Whatever the poses, no
/// point of b comes closer to a along n than at
///   c = (v_a - v_b) . n + |w_a x n| r_a + |w_b x n| r_b       (m/s)
/// where r is how far a body reaches from its centre, so that until the time t + d / c they are
/// apart for certain. Go there, find a new n and d, and so on: the times climb to the time of
/// impact and never pass it. Where c <= 0, or once the step is over, the two do not meet. For boxes
/// that do not turn, one advance along the axis that keeps them apart for longest gives the time
/// exactly.
#pragma once
#include "engine/collision/pieces.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// A body on its way through one step: constant velocity and spin, the mean of the step's.
struct Motion {
    Pose start;
    Vec3 velocity = Vec3::Zero();  // m/s
    Vec3 spin = Vec3::Zero();      // rad/s, world axes
    double reach = 0.0;            // m, of what turning moves: a ball 0, a capsule half its core
    double sweep = 0.0;            // m/s: how fast turning moves any of its points, at most

    Pose at(double time) const;
};

/// With the acceleration of the last sub-step over the coming dt (s).
Motion motionOf(const Bodies& bodies, int body, double dt);

/// How far points of the two bodies move against each other within dt (s), at most, m.
double wayOf(const Motion& a, const Motion& b, double dt);

struct Impact {
    bool meets = false;
    double time = 0.0;      // s, of the impact, or of the closest approach that was seen
    double distance = 0.0;  // m, then
    double closing = 0.0;   // m/s, of the centres along the normal then
};

/// Of two whole shapes, or of two pieces on their bodies.
Impact timeOfImpact(const Shape& shapeA, const Motion& a, const Shape& shapeB, const Motion& b,
                    double dt);
Impact timeOfImpact(const Piece& pieceA, const Motion& a, const Piece& pieceB, const Motion& b,
                    double dt);

}  // namespace engine
