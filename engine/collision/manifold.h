/// Where two shapes touch: the result of a collide function.
#pragma once
#include <array>

#include "engine/base/math.h"

namespace engine {

struct ManifoldPoint {
    Vec3 onA, onB;    // m, world axes: on the two surfaces; onB - onA is along the normal
    int feature = 0;  // the corner, edge pair or end that made the point: stable over steps
};

struct Manifold {
    static constexpr int kMaxPoints = 4;
    Vec3 normal = Vec3::Zero();  // unit, from a to b
    Vec3 slideA = Vec3::Zero(), slideB = Vec3::Zero();  // m, as in Contact
    int count = 0;
    std::array<ManifoldPoint, kMaxPoints> points;

    void add(const Vec3& onA, const Vec3& onB, int feature) {
        points[count++] = ManifoldPoint{onA, onB, feature};
    }
    double separation(int i) const { return normal.dot(points[i].onB - points[i].onA); }  // m
    /// The same contact with a and b exchanged.
    void flip() {
        normal = -normal;
        slideA.swap(slideB);
        for (int i = 0; i < count; ++i) points[i].onA.swap(points[i].onB);
    }
};

}  // namespace engine
