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
///
/// Of a large body that turns, a drum around a cube say, only the points count that the small body b can
/// meet. They end within r_b of its centre x_b, and pass there at v_a + w_a x (x_b - x_a):
///   c = (v_a + w_a x (x_b - x_a) - v_b) . n + |w_a x n| r' + |w_b x n| r_b
/// with r' a little more than r_b: it holds how far they may come from.
#pragma once
#include "engine/collision/convex.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// A body on its way through one step: constant velocity and spin, the mean of the step's.
struct Motion {
    Pose start;
    Vec3 velocity = Vec3::Zero();  // m/s
    Vec3 spin = Vec3::Zero();      // rad/s, world axes
    double reach = 0.0;            // m, of what turning moves: a ball 0, a capsule half its core
    double sweep = 0.0;            // m/s: how fast turning moves any of its points, at most
    double size = kFar;            // m: its farthest point from its centre, a ball's as well

    Pose at(double time) const;
    Vec3 placeAt(double time) const { return start.position + time * velocity; }
};

/// With the acceleration of the last sub-step over the coming dt (s).
Motion motionOf(const Bodies& bodies, int body, double dt);

/// How far points of the two bodies that may meet move against each other within dt (s), at most, m.
double wayOf(const Motion& a, const Motion& b, double dt);

struct Impact {
    bool meets = false;
    double time = 0.0;      // s, of the impact, or of the closest approach that was seen
    double distance = 0.0;  // m, then
    double closing = 0.0;   // m/s, of the centres along the normal then
};

/// Of two whole shapes, or of two pieces on their bodies. What stays farther apart than `near` (m) within
/// dt (s) is only said to do so: the distance is then one of those that are more than `near`.
Impact timeOfImpact(const Shape& shapeA, const Motion& a, const Shape& shapeB, const Motion& b,
                    double dt, double near = kFar);
Impact timeOfImpact(const Piece& pieceA, const Motion& a, const Piece& pieceB, const Motion& b,
                    double dt, double near = kFar);

}  // namespace engine
