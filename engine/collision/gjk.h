/// How far two convex pieces are apart.
///
/// GJK (Gilbert, Johnson and Keerthi 1988; van den Bergen 2003): the point v of the difference
/// B - A nearest to the origin, in a simplex of at most four of its points that is carried towards
/// the origin by the support mapping,
///   s(d) = s_B(d) - s_A(-d),
/// until no point of B - A is nearer: v.v - v.s(-v) <= epsilon v.v.
#pragma once
#include "engine/collision/convex.h"

namespace engine {

struct Closest {
    double distance = 0.0;       // m, of the cores; 0: they overlap
    Vec3 normal = Vec3::Zero();  // unit, from a to b; zero: they overlap
    Vec3 onA, onB;               // m
};

/// With b moved by `shift` (m), which onB includes. Of what is certainly farther apart than `enough` (m,
/// of the cores), the distance is only what the normal shows of it.
Closest closestPoints(const Convex& a, const Convex& b, const Vec3& shift, double enough = kFar);

}  // namespace engine
