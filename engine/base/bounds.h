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
    /// Whether from + t way is inside for some t in [0, most]: the intervals of the three slabs
    /// intersect.
    bool meets(const Vec3& from, const Vec3& way, double most) const {
        double first = 0.0, last = most;
        for (int i = 0; i < 3; ++i) {
            if (way[i] == 0.0) {
                if (from[i] < low[i] || from[i] > high[i]) return false;
                continue;
            }
            const double a = (low[i] - from[i]) / way[i], b = (high[i] - from[i]) / way[i];
            first = larger(first, smaller(a, b));
            last = smaller(last, larger(a, b));
        }
        return first <= last;
    }
    Bounds with(const Bounds& o) const { return {low.cwiseMin(o.low), high.cwiseMax(o.high)}; }
    Bounds grownBy(double m) const { return {low.array() - m, high.array() + m}; }
    /// Half the surface: proportional to the chance that a random ray hits it, the measure of a
    /// tree's cost.
    double area() const {
        const Vec3 d = high - low;
        return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
    }
};

}  // namespace engine
