/// The distance between two convex pieces.
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
    Vec3 onA = Vec3::Zero(), onB = Vec3::Zero();  // m; zero: they overlap
};

/// b is moved by `shift` (m), which onB includes. If the cores are certainly farther apart than `enough` (m),
/// the distance is only a lower bound, measured along the normal.
Closest closestPoints(const Convex& a, const Convex& b, const Vec3& shift, double enough = kFar);

}  // namespace engine
