/// When two bodies will first touch within the coming step: continuous collision detection.
///
/// Conservative advancement (Mirtich 1996; van den Bergen, GDC 2010; Catto, GDC 2013). Let the
/// shapes be `d` apart along the unit vector n, which points from a to b. Whatever the poses, no
/// point of b comes closer to a along n than at
///   c = (v_a - v_b) . n + |w_a x n| r_a + |w_b x n| r_b       (m/s)
/// where r is how far a body reaches from its centre, so until the time t + d / c they are certainly apart.
/// Advance to that time, find a new n and d, and repeat: the times approach the time of impact and never pass
/// it. Where c <= 0, or once the step is over, the two do not meet. For boxes that do not turn, one advance
/// along the axis that separates them longest gives the time exactly.
///
/// Of a large rotating body, such as a drum around a cube, only the points count that the small body b can
/// meet. They end within r_b of its centre x_b, where they move at v_a + w_a x (x_b - x_a):
///   c = (v_a + w_a x (x_b - x_a) - v_b) . n + |w_a x n| r' + |w_b x n| r_b
/// with r' a little more than r_b, for the distance that they may come from.
///
/// Of close convex pieces, the speeds of the points themselves give a second bound. Within the time t, rotation
/// brings a point r off its course of constant speed by at most |w|^2 |r| t^2 / 2, and on such courses the
/// farthest point of a piece along n comes after T to
///   n . (x + T v) + max_r (n + T n x w) . r
/// which is convex in T: between now and the step's end it is below the straight line. So the two are apart by
///   d(t) >= d + (d_end - d) t / T_end - k t^2 / 2,   k = |w_a|^2 r_a + |w_b|^2 r_b
/// A pair that turns side by side, or parts, needs one look instead of many.
#pragma once
#include "engine/collision/convex.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// The motion of a body through one step: constant velocity and spin, the mean over the step.
struct Motion {
    Pose start;
    Vec3 velocity = Vec3::Zero();  // m/s
    Vec3 spin = Vec3::Zero();      // rad/s, world axes
    double reach = 0.0;            // m, of the part that rotation moves: ball 0, capsule half its core
    double sweep = 0.0;            // m/s: the fastest that rotation moves any point
    double size = kFar;            // m: the farthest point from the centre, also for a ball

    Pose at(double time) const;
    Vec3 placeAt(double time) const { return start.position + time * velocity; }
};

/// Uses the acceleration of the last sub-step for the coming dt (s).
Motion motionOf(const Bodies& bodies, int body, double dt);

/// The farthest that points of the two bodies that may meet move relative to each other within dt (s), m.
double wayOf(const Motion& a, const Motion& b, double dt);

struct Impact {
    bool meets = false;
    double time = 0.0;      // s, of the impact, or of the closest approach found
    double distance = 0.0;  // m, at that time
    double closing = 0.0;   // m/s, of the centres along the normal at that time
};

/// For two whole shapes, or two pieces of bodies. If they stay farther apart than `near` (m) within dt (s),
/// only that is certain: the distance is then any value above `near`.
Impact timeOfImpact(const Shape& shapeA, const Motion& a, const Shape& shapeB, const Motion& b,
                    double dt, double near = kFar);
Impact timeOfImpact(const Piece& pieceA, const Motion& a, const Piece& pieceB, const Motion& b,
                    double dt, double near = kFar);

}  // namespace engine
