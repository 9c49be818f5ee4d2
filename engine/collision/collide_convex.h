/// Any convex piece against any other.
///   separation along n    s(n) = n.(s_B(-n) - s_A(n)) - r_a - r_b;  apart: the distance is max s(n)
///   flat faces            tried as n one by one: as far as one is nearly the best, the other's
///                         feature is clipped by its sides and up to four points are kept
///   anything else         the normal of the closest points (gjk.h): two points where two lines on
///                         curved sides run along each other, else one
/// Where the pieces overlap, GJK has no normal. Then b is pushed out along the line of the centres
/// until the two are a little apart, the normal n found there, and b pushed out along n instead,
/// as long as that makes the way out shorter: at the end n is a direction of least penetration.
#pragma once
#include "engine/collision/convex.h"
#include "engine/collision/manifold.h"

namespace engine {

/// Points whose separation is at most `margin` (m). A mesh's triangle holds its front only, and edges
/// that are not sharp are felt through the faces beside them.
Manifold collideConvex(const Convex& a, const Convex& b, double margin);

/// Against a half space.
Manifold collideConvexPlane(const Convex& a, const Shape& plane, const Pose& pose, double margin);

/// The distance (m) and the direction from a to b along which it is measured; not positive: they
/// touch or overlap. Behind a triangle it is kFar. More than `enough` (m) is only said to be more.
struct ConvexGap {
    double distance = 0.0;
    Vec3 normal = Vec3::UnitY();
};
ConvexGap gapOf(const Convex& a, const Convex& b, double enough = kFar);

}  // namespace engine
