/// A convex polygon in space, clipped by planes. Every corner is labelled by the two lines it lies on.
#pragma once
#include <array>

#include "engine/base/math.h"

namespace engine {

/// Corners in a ring. edge[i] names the line from corner i to corner i + 1: first the edges of the original
/// face, then the clipping planes. It has at most `Most` corners: a box's face has four edges and is cut by
/// four planes.
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

/// Keeps {x : normal . x <= offset}; the new edge is named `line`. A corner less than half a millimetre
/// outside is kept: stacked boxes of equal size have all corners on the clipping planes, and rounding would
/// rename them in every step.
template <int Most>
void clip(PolygonOf<Most>& polygon, const Vec3& normal, double offset, int line);

/// The corners of a clipped face that lie at most `margin` above the plane {n . x = height}.
template <int Most>
struct ClippedPoints {
    int count = 0;
    std::array<Vec3, Most> position;
    std::array<double, Most> separation;
    std::array<int, Most> label;  // 0 .. Most^2 - 1, of the two lines through the corner

    ClippedPoints() = default;
    ClippedPoints(const PolygonOf<Most>& polygon, const Vec3& n, double height, double margin);
    /// Keeps the deepest, the one farthest from it, and on either side of these two the one that spans the
    /// largest area: these carry load and torque as the whole polygon does.
    void keepFour(const Vec3& n);
};

/// The limit for shapes other than boxes (convex.h).
constexpr int kMostClipped = 64;
extern template void clip(PolygonOf<8>&, const Vec3&, double, int);
extern template void clip(PolygonOf<kMostClipped>&, const Vec3&, double, int);
extern template struct ClippedPoints<8>;
extern template struct ClippedPoints<kMostClipped>;

}  // namespace engine
