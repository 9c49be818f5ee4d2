#include "engine/collision/clip.h"

#include <algorithm>

namespace engine {

Polygon faceOf(const Mat3& axes, const Vec3& centre, const Vec3& half, int axis, double side) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3 middle = centre + side * half[axis] * axes.col(axis);
    const Vec3 across = half[u] * axes.col(u), up = half[v] * axes.col(v);
    Polygon face;
    face.add(middle - across - up, 0);
    face.add(middle + across - up, 1);
    face.add(middle + across + up, 2);
    face.add(middle - across + up, 3);
    return face;
}

template <int Most>
void clip(PolygonOf<Most>& polygon, const Vec3& normal, double offset, int line) {
    constexpr double kStays = 5e-4;  // m
    std::array<double, Most> height;
    bool allInside = true;
    for (int i = 0; i < polygon.count; ++i) {
        height[i] = normal.dot(polygon.corner[i]) - offset;
        allInside = allInside && height[i] <= kStays;
    }
    if (allInside) return;
    PolygonOf<Most> kept;
    for (int i = 0; i < polygon.count; ++i) {
        const int next = i + 1 < polygon.count ? i + 1 : 0;
        const Vec3 &p = polygon.corner[i], &q = polygon.corner[next];
        const double heightP = height[i], heightQ = height[next];
        const bool insideP = heightP <= kStays, insideQ = heightQ <= kStays;
        if (insideP && kept.count < Most) kept.add(p, polygon.edge[i]);
        if (insideP == insideQ || kept.count == Most) continue;
        // Stay between the two, also where the inner one is only within the tolerance: the line through both
        // may meet the plane far away.
        const double t = clamped(heightP / (heightP - heightQ), 0.0, 1.0);
        const Vec3 crossing = p + t * (q - p);
        // When leaving, the next edge runs along the plane; when entering, it continues along the old line.
        kept.add(crossing, insideP ? line : polygon.edge[i]);
    }
    std::copy_n(kept.corner.begin(), kept.count, polygon.corner.begin());
    std::copy_n(kept.edge.begin(), kept.count, polygon.edge.begin());
    polygon.count = kept.count;
}

template <int Most>
ClippedPoints<Most>::ClippedPoints(const PolygonOf<Most>& polygon, const Vec3& n, double height,
                                   double margin) {
    for (int i = 0; i < polygon.count; ++i) {
        const double s = n.dot(polygon.corner[i]) - height;
        if (s > margin) continue;
        const int before = polygon.edge[i > 0 ? i - 1 : polygon.count - 1];
        position[count] = polygon.corner[i];
        separation[count] = s;
        label[count++] = before * Most + polygon.edge[i];
    }
}

template <int Most>
void ClippedPoints<Most>::keepFour(const Vec3& n) {
    if (count <= 4) return;
    // Ties within 0.2 mm go to the first in the ring, so that the choice for a flat contact is stable.
    constexpr double kTie = 2e-4;
    int first = 0;
    for (int i = 1; i < count; ++i)
        if (separation[i] < separation[first] - kTie) first = i;
    int second = first;
    double farthest = 0.0;
    for (int i = 0; i < count; ++i) {
        const double square = (position[i] - position[first]).squaredNorm();
        if (square > farthest + kTie * kTie) farthest = square, second = i;
    }
    const Vec3 across = n.cross(position[second] - position[first]);
    int left = -1, right = -1;
    double most = 0.0, least = 0.0;
    for (int i = 0; i < count; ++i) {
        const double area = across.dot(position[i] - position[first]);
        if (area > most + kTie * kTie) most = area, left = i;
        if (area < least - kTie * kTie) least = area, right = i;
    }
    std::array<int, 4> kept{first, second, left, right};
    std::sort(kept.begin(), kept.end());
    int n4 = 0;
    for (int i = 0; i < 4; ++i) {
        if (kept[i] < 0 || (i > 0 && kept[i] == kept[i - 1])) continue;
        position[n4] = position[kept[i]];
        separation[n4] = separation[kept[i]];
        label[n4++] = label[kept[i]];
    }
    count = n4;
}

template void clip(PolygonOf<8>&, const Vec3&, double, int);
template void clip(PolygonOf<kMostClipped>&, const Vec3&, double, int);
template struct ClippedPoints<8>;
template struct ClippedPoints<kMostClipped>;

}  // namespace engine
