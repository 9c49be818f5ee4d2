/// A convex polygon in space, cut by planes, every corner labelled by the two lines it lies on.
#pragma once
#include <array>

#include "engine/base/math.h"

namespace engine {

/// Corners in a ring. edge[i] names the line from corner i to corner i + 1: 0..3 the edges of the
/// face it began as, 4..7 the planes that cut it. Eight corners at most: four edges, four cuts.
struct Polygon {
    static constexpr int kMaxCorners = 8;
    int count = 0;
    std::array<Vec3, kMaxCorners> corner;
    std::array<int, kMaxCorners> edge;

    void add(const Vec3& p, int line) {
        corner[count] = p;
        edge[count++] = line;
    }
};

/// The face of a box at side * half[axis] along its axis.
Polygon faceOf(const Mat3& axes, const Vec3& centre, const Vec3& half, int axis, double side);

/// Keeps {x : normal . x <= offset}; the new edge gets the name `line`. A corner less than half a
/// millimetre outside stays what it is: stacked boxes of one size have all corners on the cutting
/// planes, and rounding would rename them in every step.
void clip(Polygon& polygon, const Vec3& normal, double offset, int line);

/// The corners of a clipped face that are close enough to the plane {n . x = height}.
struct ClippedPoints {
    int count = 0;
    std::array<Vec3, Polygon::kMaxCorners> position;
    std::array<double, Polygon::kMaxCorners> separation;
    std::array<int, Polygon::kMaxCorners> label;  // 0..63, of the two lines through the corner

    ClippedPoints(const Polygon& polygon, const Vec3& n, double height, double margin);
    /// The deepest, the one farthest from it, and one on either side of these two that spans the
    /// largest area: what carries a load and a torque as the whole polygon does.
    void keepFour(const Vec3& n);
};

}  // namespace engine
