/// Axis-aligned boxes.
#pragma once
#include "engine/base/math.h"

namespace engine {

struct Bounds {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();

    bool overlaps(const Bounds& o) const {
        return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all();
    }
    bool contains(const Bounds& o) const {
        return (low.array() <= o.low.array()).all() && (o.high.array() <= high.array()).all();
    }
    Bounds with(const Bounds& o) const { return {low.cwiseMin(o.low), high.cwiseMax(o.high)}; }
    Bounds grownBy(double m) const { return {low.array() - m, high.array() + m}; }
    /// Half the surface: the chance that a random ray meets it, which is what a tree's cost is.
    double area() const {
        const Vec3 d = high - low;
        return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
    }
};

}  // namespace engine
