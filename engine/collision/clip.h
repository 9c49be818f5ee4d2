/// A convex polygon in space, cut by planes, every corner labelled by the two lines it lies on.
#pragma once
#include <array>

#include "engine/base/math.h"

namespace engine {

/// Corners in a ring. edge[i] names the line from corner i to corner i + 1: first the edges of the
/// face it began as, then the planes that cut it. `Most` corners at most: a box's face has four edges
/// and is cut by four planes.
template <int Most>
struct PolygonOf {
    static constexpr int kMaxCorners = Most;
    int count = 0;
    std::array<Vec3, kMaxCorners> corner;
    std::array<int, kMaxCorners> edge;

    void add(const Vec3& p, int line) {
        corner[count] = p;
        edge[count++] = line;
    }
};
using Polygon = PolygonOf<8>;

/// The face of a box at side * half[axis] along its axis.
Polygon faceOf(const Mat3& axes, const Vec3& centre, const Vec3& half, int axis, double side);

/// Keeps {x : normal . x <= offset}; the new edge gets the name `line`. A corner less than half a
/// millimetre outside stays what it is: stacked boxes of one size have all corners on the cutting
/// planes, and rounding would rename them in every step.
template <int Most>
void clip(PolygonOf<Most>& polygon, const Vec3& normal, double offset, int line);

/// The corners of a clipped face that are close enough to the plane {n . x = height}.
template <int Most>
struct ClippedPoints {
    int count = 0;
    std::array<Vec3, Most> position;
    std::array<double, Most> separation;
    std::array<int, Most> label;  // 0 .. Most^2 - 1, of the two lines through the corner

    ClippedPoints() = default;
    ClippedPoints(const PolygonOf<Most>& polygon, const Vec3& n, double height, double margin);
    /// The deepest, the one farthest from it, and one on either side of these two that spans the
    /// largest area: what carries a load and a torque as the whole polygon does.
    void keepFour(const Vec3& n);
};

/// Of boxes, and of everything else (convex.h).
constexpr int kMostClipped = 64;
extern template void clip(PolygonOf<8>&, const Vec3&, double, int);
extern template void clip(PolygonOf<kMostClipped>&, const Vec3&, double, int);
extern template struct ClippedPoints<8>;
extern template struct ClippedPoints<kMostClipped>;

}  // namespace engine
