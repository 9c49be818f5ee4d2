/// Any convex piece against any other.
///   separation along n    s(n) = n.(s_B(-n) - s_A(n)) - r_a - r_b;  apart: the distance is max s(n)
///   flat faces            tried as n one by one: as far as one is nearly the best, the other's
///                         feature is clipped by its sides and up to four points are kept
///   anything else         the normal of the closest points (gjk.h): two points where two lines on
///                         curved sides run along each other, else one
/// Where the pieces overlap, GJK gives no normal. Then b is moved along the line of the centres until the two
/// are slightly apart, the normal n is found there, and b is moved along n instead. This repeats as long as
/// the way out gets shorter; the final n is a direction of least penetration.
#pragma once
#include "engine/collision/convex.h"
#include "engine/collision/manifold.h"

namespace engine {

/// Points whose separation is at most `margin` (m). A mesh triangle is solid from its front only; edges that
/// are not sharp act through the adjacent faces, and slightly bent ones also where a piece is over no face.
Manifold collideConvex(const Convex& a, const Convex& b, double margin);

/// Against a half space.
Manifold collideConvexPlane(const Convex& a, const Shape& plane, const Pose& pose, double margin);

/// The distance (m) and the direction from a to b along which it is measured; <= 0: they touch or overlap.
/// Behind a triangle it is kFar. A distance above `enough` (m) is only a lower bound.
struct ConvexGap {
    double distance = 0.0;
    Vec3 normal = Vec3::UnitY();
};
ConvexGap gapOf(const Convex& a, const Convex& b, double enough = kFar);

/// A triangle and a piece, apart along the line from the piece's centre to the triangle: a lower bound of their
/// distance (m), and for a ball the distance; -kFar if the centre is in the triangle.
double apartFromTriangle(const Convex& triangle, const Convex& piece);

}  // namespace engine
